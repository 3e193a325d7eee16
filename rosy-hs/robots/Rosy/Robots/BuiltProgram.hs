-- |
-- Module      : Rosy.Robots.BuiltProgram
-- Description : The command line of a program that @./rosy build@ made.
--
-- In: arguments, and the folder of Rosy when the program was built. Out: a run of the program. It drives a real robot
-- itself. For the simulator it executes @./rosy run@ of itself with the same options, which starts it again
-- with a link to the simulated robot.
module Rosy.Robots.BuiltProgram
  ( runBuiltProgram,

    -- * Arguments
    Invocation (..),
    readCommandLine,
    usage,
  )
where

import Control.Exception (IOException, try)
import Control.Monad (unless)
import qualified Data.ByteString as B
import Data.List (intercalate)
import Data.Maybe (fromMaybe)
import Foreign.C.Types (CInt)
import Foreign.Ptr (nullPtr)
import Rosy.Launch (onPipe)
import Rosy.Robots.RobotRun (runOnRobotFor)
import Rosy.Robots.Target
import System.Directory (doesFileExist)
import System.Environment (getArgs, getExecutablePath, getProgName, lookupEnv)
import System.Exit (die, exitWith)
import System.IO (hSetEncoding, stderr, stdout, utf8)
import System.Posix.Process (executeFile)
import Text.Read (readMaybe)

-- ---------------------------------------------------------------------------------------------
-- Arguments

data Invocation
  = -- | An address, and for how many seconds at most.
    OnRobot String (Maybe Double)
  | -- | The simulator of the robot is at the other end of this descriptor.
    OnLink CInt
  | InSimulator
  | Help
  deriving (Eq, Show)

-- | What a program of this name was asked for, or what is wrong with it. The simulator's options are named here; what they may be
-- given is for the simulator to say.
readCommandLine :: String -> [String] -> Either String Invocation
readCommandLine self given = case given of
  [] -> Left (whichRobot self ++ " Where Rosy is, " ++ self ++ " --world room tries it in the simulator.")
  ["--link", number] | Just descriptor <- readMaybe number -> Right (OnLink descriptor)
  _ | any (`elem` ["--help", "-h"]) given -> Right Help
  _ -> options given >>= wanted
  where
    options [] = Right []
    options (word : rest) = case break (== '=') word of
      (name, '=' : value) | name `elem` known -> ((name, value) :) <$> options rest
      _ | word `notElem` known -> Left (self ++ " does not take " ++ word ++ ". " ++ self ++ " --help says what there is.")
      _ -> case rest of
        value : rest' -> ((word, value) :) <$> options rest'
        [] -> Left ("Say what " ++ word ++ " is. " ++ self ++ " --help says what there is.")
    known = "--robot" : "--seconds" : simulators
    -- What is typed last counts, as for ./rosy run.
    wanted typed = case lookup "--robot" (reverse typed) of
      Nothing -> Right InSimulator
      Just address -> case [name | (name, _) <- typed, name `elem` simulators] of
        name : _ -> Left (name ++ " is for the simulator; a real robot cannot have it.")
        [] -> OnRobot address <$> traverse seconds (lookup "--seconds" (reverse typed))
    seconds text = case readMaybe (if take 1 text == "." then '0' : text else text) of
      Just s | s >= 0, s <= longest -> Right s
      _ -> Left ("--seconds must be between 0 and " ++ show (round longest :: Int) ++ ".")

-- | What only a simulated robot has.
simulators :: [String]
simulators = ["--world", "--seed", "--speed", "--trace", "--input"]

-- | Longest run, seconds: a week, as for @./rosy run@.
longest :: Double
longest = 7 * 24 * 3600

whichRobot :: String -> String
whichRobot self = "Say which robot to drive: " ++ self ++ " --robot ws://HOST:9090, ros://HOST:11311 or serial:/dev/kobuki."

-- | What the program says of itself.
usage :: String -> String
usage self =
  intercalate
    "\n"
    [ self ++ ": a program for a robot, made by ./rosy build.",
      "",
      "  --robot ADDRESS     the robot to drive: ws://HOST:9090, ros://HOST:11311 or serial:/dev/kobuki",
      "  --seconds S         how long, in seconds of the robot",
      "",
      "Without --robot it runs in the simulator, where Rosy is, and takes what ./rosy run takes:",
      "",
      "  --world NAME|FILE  --seconds S  --seed N  --speed X|max  --trace FILE  --input FILE",
      ""
    ]

-- ---------------------------------------------------------------------------------------------
-- Run

-- | Run a program's @main@ as the command line asks. The folder is that of Rosy on the computer where the program was built.
runBuiltProgram :: FilePath -> IO () -> IO ()
runBuiltProgram home program = do
  mapM_ (`hSetEncoding` utf8) [stdout, stderr]
  self <- getProgName
  given <- getArgs
  case readCommandLine self given of
    Left why -> die why
    Right Help -> putStr (usage self)
    Right (OnLink descriptor) -> onPipe descriptor nullPtr [] [] program
    Right (OnRobot address seconds) -> onRobot seconds address program
    Right InSimulator -> inSimulator home self given

-- | Drives the robot at an address, whose profile may be a file.
onRobot :: Maybe Double -> String -> IO () -> IO ()
onRobot seconds address program = do
  profile <- try (traverse B.readFile (profileFile address))
  case profile of
    Left e -> die ("The robot's profile cannot be read: " ++ show (e :: IOException))
    Right text -> case withFile text address of
      Left e -> die (explainTargetError e)
      Right robot -> runOnRobotFor seconds robot program >>= exitWith

-- | Becomes @./rosy run@ of this file. @ROSY_ROOT@ says where Rosy is when it has moved.
inSimulator :: FilePath -> String -> [String] -> IO ()
inSimulator home self given = do
  moved <- lookupEnv "ROSY_ROOT"
  let rosy = fromMaybe home moved ++ "/rosy"
  found <- doesFileExist rosy
  unless found (die ("The simulator is a part of Rosy, which is not on this computer. " ++ whichRobot self))
  file <- getExecutablePath
  executeFile rosy False ("run" : file : given) Nothing
