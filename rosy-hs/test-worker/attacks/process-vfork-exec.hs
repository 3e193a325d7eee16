{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "execl" execl :: CString -> CString -> Ptr () -> IO CInt

main = withCString "/bin/touch" (\a -> withCString "TARGET" (\b -> execl a b nullPtr)) >>= \_ -> simulate (Velocity 0 0)
