{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "eventfd" eventfd :: CUInt -> CInt -> IO CInt

main = eventfd 0 0 >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
