{-# OPTIONS -fno-safe-haskell -package ghc #-}
{-#   options_ghc
  -fplugin=Evil
  -pgmF /bin/sh -F #-}
main = simulate (Velocity 0 0)
