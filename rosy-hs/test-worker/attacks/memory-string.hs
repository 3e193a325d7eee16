main = simulate (Say (cycle "x"))
