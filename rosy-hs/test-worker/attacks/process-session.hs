{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "setsid" setsid :: IO CInt

main = setsid >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
