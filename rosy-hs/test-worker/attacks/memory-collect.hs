import Control.Monad
import System.Mem

main = forever performGC
