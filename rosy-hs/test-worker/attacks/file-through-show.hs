import System.IO.Unsafe

newtype Leak = Leak String

instance Show Leak where
  show (Leak f) = unsafePerformIO (readFile f)

main = simulate (Say (show (Leak "CANARY")))
