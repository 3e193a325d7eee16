{-# OPTIONS_GHC -fno-warn #-}

main = simulate (Velocity 0.5 0)
