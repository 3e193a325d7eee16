{-# LANGUAGE ForeignFunctionInterface #-}
foreign import ccall "abort" abort :: IO ()

main = abort >> simulate (Velocity 0 0)
