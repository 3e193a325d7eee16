import System.Directory (removeFile)

main = simulate (Velocity 0.5 0)
