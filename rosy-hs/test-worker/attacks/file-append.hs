main = appendFile "TARGET" "x" >> simulate (Velocity 0 0)
