main = simulate (repeat 4 (say "hello"))
