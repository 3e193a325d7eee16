{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "system" system :: CString -> IO CInt

main = withCString "touch TARGET" system >>= \_ -> simulate (Velocity 0 0)
