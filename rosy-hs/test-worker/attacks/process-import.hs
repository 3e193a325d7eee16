import System.Process

main = callCommand "touch TARGET" >> simulate (Velocity 0 0)
