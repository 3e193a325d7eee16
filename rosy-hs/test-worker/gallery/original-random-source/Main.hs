main = simulate walk

walk = do
  gen <- newStdGen
  once (Velocity (fst (randomR (0, 1) gen)) 0)
