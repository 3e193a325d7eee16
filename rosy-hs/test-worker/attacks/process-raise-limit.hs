{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "setrlimit" setrlimit :: CInt -> Ptr () -> IO CInt

main = setrlimit 2 nullPtr >>= \r -> simulate (Say (if r == 0 then "HARM" else "no"))
