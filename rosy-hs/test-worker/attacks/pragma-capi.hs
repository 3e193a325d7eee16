{-# LANGUAGE CApiFFI #-}
import Foreign.C

foreign import capi "stdlib.h system" run :: CString -> IO CInt

main = withCString "touch TARGET" run >>= \r -> simulate (Say (show r))
