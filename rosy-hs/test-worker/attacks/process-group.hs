{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "setpgid" setpgid :: CInt -> CInt -> IO CInt

main = setpgid 0 0 >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
