{-# LINE 4711 "CANARY" #-}
main = simulate (Say missing)
