n = 0
n = n + 1

main = simulate (\_ -> Say (show n))
