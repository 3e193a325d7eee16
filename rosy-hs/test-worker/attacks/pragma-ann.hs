{-# ANN module (readFile "CANARY") #-}
main = simulate (Velocity 0 0)
