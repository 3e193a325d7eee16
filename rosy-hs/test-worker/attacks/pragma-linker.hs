{-# OPTIONS_GHC -pgml /bin/touch -optl TARGET -fobject-code #-}
main = simulate (Velocity 0 0)
