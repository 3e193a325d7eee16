{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "popen" popen :: CString -> CString -> IO (Ptr ())

main = withCString "touch TARGET" (\a -> withCString "w" (popen a)) >>= \p -> simulate (Say (if p == nullPtr then "no" else "HARM"))
