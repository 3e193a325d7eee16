{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "shm_open" shmOpen :: CString -> CInt -> CUInt -> IO CInt

main = withCString "/rosy-attack" (\n -> shmOpen n 0x42 384) >>= \r -> simulate (Say (if r >= 0 then "HARM" else "no"))
