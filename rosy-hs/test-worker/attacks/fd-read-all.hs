{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "read" read_ :: CInt -> CString -> CSize -> IO CLong

main = read_ 3 nullPtr 0 >>= \r -> simulate (Say (show r))
