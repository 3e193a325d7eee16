import Control.Monad.ST.Unsafe (unsafeIOToST)
import Control.Monad.ST

main = simulate (Say (runST (unsafeIOToST (readFile "CANARY"))))
