{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "statvfs" statvfs :: CString -> CString -> IO CInt

main = withCString "/" (\f -> withCString (replicate 256 ' ') (statvfs f)) >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
