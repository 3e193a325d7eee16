points :: [(Double, Double)]
points = [(x, y) | x <- [0, 0.5 .. 2], let y = x * x, y < 3]

total :: Double
total = sum [fst p | p <- points] + sum (map snd points)

evens = [x | Just x <- [Just 2, Nothing], even x]

main = simulate (Say (show total))
