back :: Velocity
back = Velocity (-0.2) 0

spin :: Double -> Velocity
spin x = Velocity 0 (- x)

sums :: [Double]
sums = [-1, - 2, 3 - 4, 3 + (-4), -x * 2, negate 5, (-6) - 7]
  where x = -8

sign :: Double -> Int
sign 0 = 0
sign (-1) = -1
sign x | x < 0 = -1 | otherwise = 1

main = simulate back
