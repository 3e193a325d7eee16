import Control.Monad
import System.Mem.Weak

again :: Int -> IO ()
again n = mkWeakPtr n (Just (again (n + 1) >> again (n + 2))) >> pure ()

main = again 0 >> forever (pure $! length [1 .. 1000 :: Int])
