five :: Int
five = fromIntegral (5 :: Integer)

rounded = (round (2.7 :: Double) :: Int) + 1

empty = [] :: [Int]

main = simulate (Say (show (five, rounded, empty)))
