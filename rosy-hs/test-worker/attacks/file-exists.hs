{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "access" access :: CString -> CInt -> IO CInt

main = withCString "CANARY" (\f -> access f 0) >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
