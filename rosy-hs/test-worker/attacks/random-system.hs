import System.Random

main = do
  setStdGen (mkStdGen 1)
  mapM_ (\n -> newStdGen >>= \g -> n `seq` g `seq` pure ()) [1 :: Int ..]
  simulate (Velocity 0 0)
