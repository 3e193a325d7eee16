{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign
import Foreign.C

foreign import ccall "sched_setaffinity" affinity :: CInt -> CSize -> Ptr CULong -> IO CInt

main = alloca (\p -> poke p 1 >> affinity 0 8 p) >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
