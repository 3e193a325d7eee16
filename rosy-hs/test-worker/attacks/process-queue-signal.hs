{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "sigqueue" sigqueue :: CInt -> CInt -> Ptr () -> IO CInt

main = sigqueue VICTIM 9 nullPtr >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
