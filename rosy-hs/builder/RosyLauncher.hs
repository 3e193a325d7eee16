-- |
-- Module      : RosyLauncher
-- Description : Where a built program begins: finds the robot that the command line names and lets the program drive it.
--
-- The robot is a real one, or the simulator's: @./rosy run BIN@, with all its options, starts the program with a link to it.
module RosyLauncher (main) where

import Control.Exception (IOException, try)
import Control.Monad (void)
import qualified Data.ByteString as B
import Foreign.Ptr (nullPtr)
import qualified Main as Program
import Rosy.Launch (onPipe)
import Rosy.Robots.Drive (drive)
import Rosy.Robots.Target
import System.Environment (getArgs, getExecutablePath, getProgName)
import System.Exit (die, exitWith)
import System.IO (hSetEncoding, stderr, stdout, utf8)
import Text.Read (readMaybe)

main :: IO ()
main = do
  given <- getArgs
  case given of
    ["--robot", address] -> reach address
    ["--link", number] | Just descriptor <- readMaybe number -> onPipe descriptor nullPtr (void Program.main)
    [] -> do
      name <- getProgName
      die ("This program drives a robot; say which one: " ++ name ++ " --robot ws://HOST:9090, ros://HOST:11311 or serial:/dev/kobuki.")
    _ -> do
      self <- getExecutablePath
      die ("This program has no simulator of its own. Where Rosy is, start it with: ./rosy run " ++ unwords (self : given))

-- | Drives the robot at an address, whose profile may be a file.
reach :: String -> IO ()
reach address = do
  mapM_ (`hSetEncoding` utf8) [stdout, stderr]
  profile <- try (traverse B.readFile (profileFile address))
  case profile of
    Left e -> die ("The robot's profile cannot be read: " ++ show (e :: IOException))
    Right text -> case withFile text address of
      Left e -> die (explainTargetError e)
      Right robot -> drive robot (void Program.main) >>= exitWith
