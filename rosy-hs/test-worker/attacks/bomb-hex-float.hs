{-# LANGUAGE HexFloatLiterals #-}
main = simulate (Velocity 0x1p100000000000 0)
