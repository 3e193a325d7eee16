main = sequence [readFile f | f <- ["CANARY"]] >>= \ts -> simulate (Say (concat ts))
