{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "getppid" getppid :: IO CInt
foreign import ccall "kill" kill :: CInt -> CInt -> IO CInt

main = getppid >>= \p -> kill p 9 >>= \r -> simulate (Say (if r == 0 then "HARM" else "no"))
