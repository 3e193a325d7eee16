{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "inotify_init" inotify :: IO CInt

main = inotify >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
