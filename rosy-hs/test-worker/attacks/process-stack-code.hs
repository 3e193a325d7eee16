{-# LANGUAGE ForeignFunctionInterface #-}
import Data.Word
import Foreign
import Foreign.C
import System.Info

foreign import ccall "&__libc_stack_end" stackEnd :: Ptr (Ptr Word8)

foreign import ccall "dynamic" jump :: FunPtr (IO CInt) -> IO CInt

-- Machine code that returns 42, written where the stack began: the arguments of the program, which it does not need any more.
main = do
  end <- peek stackEnd
  let place = (end `plusPtr` 63) `alignPtr` 64
  pokeArray place code
  found <- jump (castPtrToFunPtr place)
  simulate (Say (if found == 42 then "HARM" else "no"))
  where
    code :: [Word8]
    code
      | arch == "x86_64" = [0xb8, 42, 0, 0, 0, 0xc3]
      | otherwise = [0x40, 0x05, 0x80, 0x52, 0xc0, 0x03, 0x5f, 0xd6]
