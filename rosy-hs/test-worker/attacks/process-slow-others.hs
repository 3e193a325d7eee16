{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "setpriority" setpriority :: CInt -> CUInt -> CInt -> IO CInt

main = setpriority 0 VICTIM 19 >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
