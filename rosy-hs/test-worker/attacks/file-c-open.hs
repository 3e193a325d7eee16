import System.Posix.Internals
import Foreign.C.String

main = do
  r <- withCString "TARGET" (\p -> c_open p 577 420)
  simulate (Say (show r))
