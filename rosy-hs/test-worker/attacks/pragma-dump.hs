{-# OPTIONS_GHC -ddump-parsed -ddump-to-file -dumpdir TARGET #-}
main = simulate (Velocity 0 0)
