-- |
-- Module      : Main
-- Description : rosy-worker: compiles and runs robot programs for the service.
--
-- Parses the options, opens a compiler session and serves the socket (protocol/README.md, section 3).
module Main (main) where

import Data.Maybe (fromMaybe)
import Rosy.Worker.ChildProcess (Settings (..))
import Rosy.Worker.Ghc (start)
import Rosy.Worker.Options (Options (..), findLibrary, parseOptions)
import Rosy.Worker.Server (Config (..), serve)
import Rosy.Worker.SystemCalls (deferCollections, dropCapabilities, machineMemory)
import System.Environment (getArgs)
import System.Exit (die)
import System.IO (IOMode (ReadWriteMode), openFile)
import System.Posix.IO (handleToFd)

main :: IO ()
main = do
  arguments <- getArgs
  options <- either die pure (parseOptions arguments)
  library <- findLibrary options >>= either die pure
  deferCollections
  session <- start library
  empty <- openFile "/dev/null" ReadWriteMode >>= handleToFd
  dropCapabilities
  half <- (`div` 2) <$> machineMemory
  serve
    Config
      { socket = socketFd options,
        settings = Settings {protections = enabledProtections options, compileMemory = checkMemory options, runSeconds = runCpu options, nullFd = empty},
        compileSeconds = checkSeconds options,
        maxConcurrentChecks = checkLimit options,
        memoryTotal = fromMaybe half (totalMemory options)
      }
    session
