{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "dup2" dup2 :: CInt -> CInt -> IO CInt

main = dup2 0 900 >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
