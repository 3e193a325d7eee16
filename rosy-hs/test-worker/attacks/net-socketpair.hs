{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Marshal.Array
import Foreign.Ptr

foreign import ccall "socketpair" socketpair :: CInt -> CInt -> CInt -> Ptr CInt -> IO CInt

main = allocaArray 2 (socketpair 1 1 0) >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
