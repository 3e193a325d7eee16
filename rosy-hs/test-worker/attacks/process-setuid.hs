{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "setuid" setuid :: CUInt -> IO CInt

main = setuid 0 >>= \r -> simulate (Say (if r == 0 then "HARM" else "no"))
