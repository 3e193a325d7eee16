level :: Double -> String
level d = case compare d 0.5 of
  LT | d < 0.1 -> "very low"
     | d < 0.2 -> "low"
     | otherwise -> "middle"
  EQ -> "half"
  GT -> rest
    where rest | d > 0.9 = "full"
               | otherwise = "high"

main = simulate (Say (level 0.3))
