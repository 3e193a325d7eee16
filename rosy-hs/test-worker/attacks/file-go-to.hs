{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "chdir" chdir :: CString -> IO CInt

main = withCString "/" chdir >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
