{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "timerfd_create" timerfd :: CInt -> CInt -> IO CInt

main = timerfd 1 0 >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
