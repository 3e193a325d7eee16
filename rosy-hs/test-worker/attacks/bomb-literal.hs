main = simulate (Say (show (9 ^ (9 ^ 9))))
