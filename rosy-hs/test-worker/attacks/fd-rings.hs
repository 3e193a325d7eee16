{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign
import Foreign.C

foreign import ccall "syscall" ringSetup :: CLong -> CUInt -> Ptr CULong -> IO CLong

main = allocaArray 15 (\p -> pokeArray p (replicate 15 0) >> ringSetup 425 1 p) >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
