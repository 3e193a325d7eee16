{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "opendir" opendir :: CString -> IO (Ptr ())

main = withCString "/" opendir >>= \r -> simulate (Say (if r /= nullPtr then "HARM" else "no"))
