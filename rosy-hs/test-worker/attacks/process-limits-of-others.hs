{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign
import Foreign.C

foreign import ccall "prlimit" prlimit :: CInt -> CInt -> Ptr () -> Ptr CULong -> IO CInt

main = allocaArray 2 (prlimit VICTIM 7 nullPtr) >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
