import GHC.IO.Handle.FD
import System.IO (IOMode (..), hGetContents)

main = openFile "CANARY" ReadMode >>= hGetContents >>= \t -> simulate (Say t)
