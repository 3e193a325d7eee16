import Control.Concurrent.MVar

main = newEmptyMVar >>= takeMVar >>= simulate . Say
