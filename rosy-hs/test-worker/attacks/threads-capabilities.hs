import GHC.Conc

main = setNumCapabilities 64 >> simulate (Velocity 0 0)
