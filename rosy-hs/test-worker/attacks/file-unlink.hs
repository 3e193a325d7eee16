{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C

foreign import ccall "unlink" unlink :: CString -> IO CInt

main = withCString "CANARY" unlink >>= \r -> simulate (Say (show r))
