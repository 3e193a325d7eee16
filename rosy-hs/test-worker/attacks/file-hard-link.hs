{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "link" link :: CString -> CString -> IO CInt

main = withCString "CANARY" (\f -> withCString "TARGET" (link f)) >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
