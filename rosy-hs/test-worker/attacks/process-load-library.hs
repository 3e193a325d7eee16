{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "dlopen" dlopen :: CString -> CInt -> IO (Ptr ())

main = withCString "libresolv.so.2" (\n -> dlopen n 2) >>= \r -> simulate (Say (if r /= nullPtr then "HARM" else "no"))
