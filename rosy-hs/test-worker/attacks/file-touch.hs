{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "utimes" utimes :: CString -> Ptr () -> IO CInt

main = withCString "CANARY" (\f -> utimes f nullPtr) >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
