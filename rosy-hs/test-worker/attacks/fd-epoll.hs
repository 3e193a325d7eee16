{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "epoll_create1" epoll :: CInt -> IO CInt

main = epoll 0 >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
