{-# LANGUAGE ForeignFunctionInterface #-}
import Foreign

foreign import ccall "stopTimer" stopTimer :: IO ()

main = stopTimer >> simulate (Say (show (length [1 ..])))
