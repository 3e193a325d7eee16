{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "tgkill" tgkill :: CInt -> CInt -> CInt -> IO CInt

main = tgkill VICTIM VICTIM 9 >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
