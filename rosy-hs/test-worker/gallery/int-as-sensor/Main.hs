main = simulate count

count :: Int -> Velocity
count n = Velocity (fromIntegral n) 0
