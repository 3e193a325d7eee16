{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C

foreign import ccall "mkdir" mkdir :: CString -> CUInt -> IO CInt

main = withCString "TARGET" (\a -> mkdir a 511) >>= \r -> simulate (Say (show r))
