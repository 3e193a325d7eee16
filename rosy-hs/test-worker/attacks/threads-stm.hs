import GHC.Conc

main = atomically retry >> simulate (Velocity 0 0)
