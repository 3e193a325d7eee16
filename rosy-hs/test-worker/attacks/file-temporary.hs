{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "tmpfile" tmpfile :: IO (Ptr ())

main = tmpfile >>= \r -> simulate (Say (if r /= nullPtr then "HARM" else "no"))
