{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "chmod" chmod :: CString -> CUInt -> IO CInt

main = withCString "CANARY" (\f -> chmod f 511) >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
