{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "prctl" prctl :: CInt -> CULong -> CULong -> CULong -> CULong -> IO CInt

main = prctl 1 0 0 0 0 >>= \r -> simulate (Say (if r == 0 then "HARM" else "no"))
