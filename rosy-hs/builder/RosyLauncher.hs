-- |
-- Module      : RosyLauncher
-- Description : Where a built program begins: finds the robot that the command line names and lets the program drive it.
module RosyLauncher (main) where

import Control.Exception (IOException, try)
import Control.Monad (void)
import qualified Data.ByteString as B
import qualified Main as Program
import Rosy.Robots.Drive (drive)
import Rosy.Robots.Target
import System.Environment (getArgs, getProgName)
import System.Exit (die, exitWith)
import System.IO (hSetEncoding, stderr, stdout, utf8)

main :: IO ()
main = do
  given <- getArgs
  case given of
    ["--robot", address] -> reach address
    _ -> do
      name <- getProgName
      die ("This program drives a robot; say which one: " ++ name ++ " --robot ws://HOST:9090, ros://HOST:11311 or serial:/dev/kobuki.")

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
