{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "kill" kill :: CInt -> CInt -> IO CInt

main = kill VICTIM 0 >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
