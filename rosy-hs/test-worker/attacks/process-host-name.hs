{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "sethostname" sethostname :: CString -> CSize -> IO CInt

main = withCString "harm" (\n -> sethostname n 4) >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
