{-# LANGUAGE PackageImports #-}
import "base" System.IO.Unsafe (unsafePerformIO)
import "ghc" GHC (runGhc)

main = simulate (Say (unsafePerformIO (Prelude.readFile "CANARY")))
