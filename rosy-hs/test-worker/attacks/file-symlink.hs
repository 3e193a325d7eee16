{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C

foreign import ccall "symlink" symlink :: CString -> CString -> IO CInt

main = withCString "CANARY" (\a -> withCString "TARGET" (\b -> symlink a b)) >>= \r -> simulate (Say (show r))
