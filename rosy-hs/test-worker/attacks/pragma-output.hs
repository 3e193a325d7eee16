{-# OPTIONS_GHC -o TARGET -hidir TARGET -odir TARGET -keep-tmp-files -tmpdir TARGET #-}
main = simulate (Velocity 0 0)
