{-# OPTIONS_GHC -F -pgmF /bin/touch -optF TARGET #-}
main = simulate (Velocity 0 0)
