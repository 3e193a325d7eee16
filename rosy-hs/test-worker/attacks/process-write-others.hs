{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "process_vm_writev" writeOthers :: CInt -> Ptr () -> CULong -> Ptr () -> CULong -> CULong -> IO CLong

main = writeOthers VICTIM nullPtr 0 nullPtr 0 0 >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
