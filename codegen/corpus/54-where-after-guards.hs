grade :: Int -> Char
grade n
  | p >= 90 = 'A'
  | p >= 80 = 'B'
  | p >= 70 = 'C'
  | otherwise = 'F'
  where
    p = n * 100 `div` total
    total = 50

main = simulate (Say [grade 45])
