import Control.Concurrent
import Control.Exception
import Control.Monad

main = do
  me <- myThreadId
  _ <- forkIO (forever (throwTo me ThreadKilled))
  forever (simulate (Velocity 0 0) `catch` \e -> const (pure ()) (e :: AsyncException))
