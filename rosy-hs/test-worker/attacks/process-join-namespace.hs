{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "open" open :: CString -> CInt -> IO CInt

foreign import ccall "setns" setns :: CInt -> CInt -> IO CInt

main = withCString "/proc/self/ns/net" (\f -> open f 0) >>= \n -> setns n 0 >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
