{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "personality" personality :: CULong -> IO CInt

main = personality 0xffffffff >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
