{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign.C
import Foreign.Ptr

foreign import ccall "signal" signal :: CInt -> Ptr () -> IO (Ptr ())

-- 1 is SIG_IGN: the signals that end a process, and that of the limit of computing time.
main = mapM_ (\n -> signal n (nullPtr `plusPtr` 1)) [1, 2, 15, 24] >> simulate (Say (show (length [1 ..])))
