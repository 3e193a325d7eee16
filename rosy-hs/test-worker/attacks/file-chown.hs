{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "chown" chown :: CString -> CUInt -> CUInt -> IO CInt

main = withCString "CANARY" (\f -> chown f maxBound maxBound) >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
