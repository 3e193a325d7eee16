import GHC.IO (unsafePerformIO)

main = simulate leak

leak :: Velocity -> Say
leak _ = Say (unsafePerformIO (readFile "CANARY"))
