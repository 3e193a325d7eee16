{-# LANGUAGE ForeignFunctionInterface #-}
foreign export ccall harm :: Int -> Int

harm :: Int -> Int
harm = (+ 1)

main = simulate (Velocity 0 0)
