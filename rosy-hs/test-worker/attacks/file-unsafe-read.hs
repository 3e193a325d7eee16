import System.IO.Unsafe

main = simulate leak

leak :: Velocity -> Say
leak _ = Say (unsafePerformIO (readFile "CANARY"))
