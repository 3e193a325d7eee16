main = simulate (say 'hello')
