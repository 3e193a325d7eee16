import Data.Typeable

f0 x = (x, x)

f1 x = f0 (f0 (f0 (f0 x)))

f2 x = f1 (f1 (f1 (f1 x)))

main = simulate (Say (show (typeOf (f2 (f1 'x')))))
