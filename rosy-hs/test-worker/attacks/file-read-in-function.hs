main = readFile "CANARY" >>= \s -> simulate (leak s)

leak :: String -> Velocity -> Say
leak s _ = Say s
