{-# LANGUAGE Trustworthy #-}
import System.IO.Unsafe

main = simulate (Say (unsafePerformIO (readFile "CANARY")))
