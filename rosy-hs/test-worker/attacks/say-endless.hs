main = simulate (Say (cycle "ha "))
