main = writeFile "TARGET" "x" >> simulate (Velocity 0 0)
