{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign
import Foreign.C

foreign import ccall "sched_setscheduler" schedule :: CInt -> CInt -> Ptr CInt -> IO CInt

main = alloca (\p -> poke p 0 >> schedule 0 3 p) >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
