main = readFile "/proc/self/environ" >>= \s -> simulate (Say s)
