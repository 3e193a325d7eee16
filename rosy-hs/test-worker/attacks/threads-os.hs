import Control.Concurrent

main = forkOS (pure ()) >> simulate (Say "HARM")
