{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign
import Foreign.C

foreign import ccall "signalfd" signalfd :: CInt -> Ptr CULong -> CInt -> IO CInt

main = alloca (\s -> poke s 0 >> signalfd (-1) s 0) >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
