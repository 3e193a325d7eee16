main = simulate (Say (show (maximum [minBound .. maxBound :: Int])))
