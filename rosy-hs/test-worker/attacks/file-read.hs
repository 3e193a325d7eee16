main = readFile "CANARY" >>= \s -> simulate (Say s)
