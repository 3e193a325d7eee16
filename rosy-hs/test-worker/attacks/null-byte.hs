main = simulate (Say "\0\0\0")
