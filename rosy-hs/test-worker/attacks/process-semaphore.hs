{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "semget" semget :: CInt -> CInt -> CInt -> IO CInt

main = semget 0 1 0x3b6 >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
