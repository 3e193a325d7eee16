double :: [Int] -> [Int]
double = map (* 2)

others :: [Int -> Int]
others = [(+ 1), (2 *), (subtract 3), (`div` 2), (10 `div`), (^ 2), (2 ^)]

pairs = zipWith (,) [1 ..] "abc"
triples = zipWith3 (,,) [1 ..] "abc" [True, False]

main = simulate (Say . show . double)
