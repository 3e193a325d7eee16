import Control.Monad.ST.Unsafe
import Control.Monad.ST

main = simulate leak

leak :: Velocity -> Say
leak _ = Say (runST (unsafeIOToST (readFile "CANARY")))
