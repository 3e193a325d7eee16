{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C

foreign import ccall "socket" socket :: CInt -> CInt -> CInt -> IO CInt

main = socket 2 1 0 >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
