-- |
-- Module      : Main
-- Description : rosy-worker: compiles and runs robot programs for the service.
--
-- Reads its options, warms up and serves the socket it was given (protocol/README.md, section 3).
module Main (main) where

import Rosy.Worker.Child (Settings (..))
import Rosy.Worker.Ghc (start)
import Rosy.Worker.Options (Options (..), findLibrary, parseOptions)
import Rosy.Worker.Server (Config (..), serve)
import System.Environment (getArgs)
import System.Exit (die)
import System.Posix.IO (OpenMode (ReadWrite), defaultFileFlags, openFd)

main :: IO ()
main = do
  arguments <- getArgs
  options <- either die pure (parseOptions arguments)
  library <- findLibrary options >>= either die pure
  session <- start library
  empty <- openFd "/dev/null" ReadWrite Nothing defaultFileFlags
  serve
    Config
      { socket = socketFd options,
        settings = Settings {layers = withLayers options, compileMemory = checkMemory options, runSeconds = runCpu options, nullFd = empty},
        compileSeconds = checkSeconds options,
        checksAtOnce = checksTogether options
      }
    session
