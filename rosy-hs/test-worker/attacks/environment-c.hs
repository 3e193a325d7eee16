{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "getenv" getenv :: CString -> IO CString

main = withCString "ROSY_TEST_SECRET" getenv >>= \p -> (if p == nullPtr then pure "none" else peekCString p) >>= \s -> simulate (Say s)
