import System.Posix.Process

main = forkProcess (pure ()) >> simulate (Say "HARM")
