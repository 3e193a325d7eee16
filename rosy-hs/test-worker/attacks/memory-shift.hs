import Data.Bits

main = simulate (Say (show (popCount (shiftL 1 maxBound :: Integer) + popCount (unsafeShiftL 1 minBound :: Integer))))
