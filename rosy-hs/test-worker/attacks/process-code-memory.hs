{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "mmap" mmap :: Ptr () -> CSize -> CInt -> CInt -> CInt -> CLong -> IO (Ptr ())

main = mmap nullPtr 4096 7 0x22 (-1) 0 >>= \p -> simulate (Say (if ptrToIntPtr p == -1 then "no" else "HARM"))
