{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "msgget" msgget :: CInt -> CInt -> IO CInt

main = msgget 0 0x3b6 >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
