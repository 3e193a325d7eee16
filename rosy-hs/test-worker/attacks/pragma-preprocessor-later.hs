main = simulate (Velocity 0 0)
{-# OPTIONS_GHC -F -pgmF /bin/touch -optF TARGET #-}
