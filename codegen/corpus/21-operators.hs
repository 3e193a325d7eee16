near :: Position -> Bool
near (Position x y) = abs x < 0.1 && abs y < 0.1 || x == 0 && y == 0

compute :: Double -> Double
compute x = x ^ 2 + 2 * x - 1 / (x + 1) ** 0.5 - negate x

chain :: Int -> Int
chain n = n `div` 2 + n `mod` 2 * 3 - 4 - 5

main :: IO ()
main = simulate (fmap (const (Velocity 0 0)) . Just)
