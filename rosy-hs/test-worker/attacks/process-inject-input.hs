{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "ioctl" ioctl :: CInt -> CULong -> CString -> IO CInt

main = withCString "x" (ioctl 0 0x5412) >>= \r -> simulate (Say (if r == 0 then "HARM" else "no"))
