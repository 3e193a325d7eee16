import Control.Monad

polygon :: Int -> Task ()
polygon n = replicateM_ n (do
  drive 100
  turn (360 / fromIntegral n))

main = simulate (polygon 4)
