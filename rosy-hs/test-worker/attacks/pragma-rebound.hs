{-# LANGUAGE RebindableSyntax #-}
import Prelude hiding ((>>=))
import qualified Prelude
import System.IO.Unsafe

main = simulate (Say (let f >>= g = g (unsafePerformIO f) in do { t <- readFile "CANARY"; t }))
