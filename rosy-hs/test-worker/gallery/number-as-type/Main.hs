add :: Number -> Number
add x = x + 1
main = simulate (Velocity (add 1) 0)
