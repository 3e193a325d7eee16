import Control.Concurrent

main = mapM_ (\_ -> forkIO (threadDelay 100000000)) [1 .. 100000 :: Int] >> simulate (Velocity 0 0)
