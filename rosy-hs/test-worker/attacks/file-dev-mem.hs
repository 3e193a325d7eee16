main = readFile "/dev/mem" >>= \s -> simulate (Say (take 10 s))
