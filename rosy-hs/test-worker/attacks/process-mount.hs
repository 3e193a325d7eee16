{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "unshare" unshare :: CInt -> IO CInt

main = unshare 0x20000 >>= \r -> simulate (Say (if r == 0 then "HARM" else "no"))
