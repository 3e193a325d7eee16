{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "open" open :: CString -> CInt -> IO CInt

main = withCString "CANARY" (\f -> open f 0x401) >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
