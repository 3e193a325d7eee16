{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign
import Foreign.C

foreign import ccall "mprotect" protect :: Ptr Word8 -> CSize -> CInt -> IO CInt

main = mallocBytes 16384 >>= \p -> protect (p `alignPtr` 4096) 4096 5 >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
