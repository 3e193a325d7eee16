{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "mkfifo" mkfifo :: CString -> CUInt -> IO CInt

main = withCString "TARGET" (\f -> mkfifo f 511) >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
