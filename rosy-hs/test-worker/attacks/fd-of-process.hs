{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "syscall" pidfdOpen :: CLong -> CInt -> CUInt -> IO CLong

main = pidfdOpen 434 VICTIM 0 >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
