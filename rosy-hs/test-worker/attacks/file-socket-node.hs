{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "mknod" mknod :: CString -> CUInt -> CULong -> IO CInt

main = withCString "TARGET" (\f -> mknod f 0xc1ff 0) >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
