{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "fork" fork :: IO CInt

main = fork >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
