import System.Directory

main = removeFile "CANARY" >> simulate (Velocity 0 0)
