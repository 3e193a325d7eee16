{-# LANGUAGE PackageImports #-}
import "base" System.IO.Unsafe (unsafePerformIO)
import "process" System.Process (system)

main = simulate (Say (unsafePerformIO (Prelude.readFile "CANARY")))
