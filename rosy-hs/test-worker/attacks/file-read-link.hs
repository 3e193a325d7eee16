{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "readlink" readlink :: CString -> CString -> CSize -> IO CLong

main = withCString "/proc/self/exe" (\f -> withCString "                    " (\to -> readlink f to 20)) >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
