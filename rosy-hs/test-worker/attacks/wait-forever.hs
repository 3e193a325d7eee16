main = simulate (mapM_ wait [0 / 0, -1 / 0, -1e300, 1 / 0])
