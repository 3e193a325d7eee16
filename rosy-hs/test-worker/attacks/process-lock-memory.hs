{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "mlockall" mlockall :: CInt -> IO CInt

main = mlockall 1 >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
