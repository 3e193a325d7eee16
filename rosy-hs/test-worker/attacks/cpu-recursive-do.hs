import Control.Monad.Fix

main = mfix (\x -> x `seq` pure x) >>= simulate . Say
