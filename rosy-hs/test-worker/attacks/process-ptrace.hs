{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "ptrace" ptrace :: CLong -> CInt -> Ptr () -> Ptr () -> IO CLong

main = ptrace 16 VICTIM nullPtr nullPtr >>= \r -> simulate (Say (if r == 0 then "HARM" else "no"))
