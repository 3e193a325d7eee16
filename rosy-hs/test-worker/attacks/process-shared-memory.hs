{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "shmget" shmget :: CInt -> CSize -> CInt -> IO CInt

main = shmget 0 4096 0x3b6 >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
