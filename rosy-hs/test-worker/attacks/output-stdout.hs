main = mapM_ putStrLn (replicate 100000 "{\"op\":\"gone\"}") >> simulate (Velocity 0 0)
