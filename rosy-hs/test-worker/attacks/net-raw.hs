{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "socket" socket :: CInt -> CInt -> CInt -> IO CInt

main = socket 2 3 1 >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
