{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C

foreign import ccall "rename" rename :: CString -> CString -> IO CInt

main = withCString "CANARY" (\a -> withCString "TARGET" (\b -> rename a b)) >>= \r -> simulate (Say (show r))
