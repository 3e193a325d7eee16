import Data.Array.Base (unsafeAt)
import Data.Array.Unboxed

main = simulate (Say (show (unsafeAt (listArray (0, 1) [1, 2] :: UArray Int Int) 100000000000)))
