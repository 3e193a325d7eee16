{-# LINE 1 "Main.hs" #-}
-- a harmless line
{-# line 2 "Main.hs" #-}
main = readFile "CANARY" >>= \t -> simulate (Say t)
