{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign
import Foreign.C

foreign import ccall "name_to_handle_at" handleOf :: CInt -> CString -> Ptr CUInt -> Ptr CInt -> CInt -> IO CInt

main = withCString "/" (\f -> allocaArray 40 (\h -> poke h 128 >> alloca (\m -> handleOf (-100) f h m 0))) >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
