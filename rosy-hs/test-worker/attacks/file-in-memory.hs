{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "memfd_create" memfd :: CString -> CUInt -> IO CInt

main = withCString "harm" (\f -> memfd f 0) >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
