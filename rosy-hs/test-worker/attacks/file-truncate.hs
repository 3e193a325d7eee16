{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "truncate" truncateTo :: CString -> CLong -> IO CInt

main = withCString "CANARY" (\f -> truncateTo f 0) >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
