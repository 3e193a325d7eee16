{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "raise" raise :: CInt -> IO CInt

main = raise 11 >> simulate (Velocity 0 0)
