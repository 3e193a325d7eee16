{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "socket" socket :: CInt -> CInt -> CInt -> IO CInt

main = socket 16 3 0 >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
