{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "alarm" alarm :: CUInt -> IO CUInt

main = alarm 1 >> simulate (Velocity 0 0)
