main = getLine >>= \s -> simulate (Say s)
