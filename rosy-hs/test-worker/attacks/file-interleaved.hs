import System.IO.Unsafe (unsafeInterleaveIO)

main = unsafeInterleaveIO (readFile "CANARY") >>= \t -> simulate (Say t)
