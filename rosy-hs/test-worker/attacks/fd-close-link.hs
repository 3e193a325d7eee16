{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "close" close :: CInt -> IO CInt

main = mapM_ close [0 .. 1000] >> simulate (Velocity 0 0)
