{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "chroot" chroot :: CString -> IO CInt

main = withCString "/" chroot >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
