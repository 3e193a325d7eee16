import System.IO

main = openFile "TARGET" WriteMode >>= \h -> hPutStr h "x" >> hClose h >> simulate (Velocity 0 0)
