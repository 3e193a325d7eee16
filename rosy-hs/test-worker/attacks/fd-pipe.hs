{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign
import Foreign.C

foreign import ccall "pipe" pipe :: Ptr CInt -> IO CInt

main = allocaArray 2 pipe >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
