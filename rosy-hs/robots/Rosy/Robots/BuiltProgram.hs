{-# LANGUAGE OverloadedStrings #-}

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
import Control.Monad (unless, (>=>))
import qualified Data.ByteString as B
import Data.Maybe (fromMaybe)
import qualified Data.Text as T
import qualified Data.Text.IO as T
import Foreign.C.Types (CInt)
import Foreign.Ptr (nullPtr)
import Rosy.Launch (onPipe)
import Rosy.Link.Mailbox (mapMailbox, noMailbox)
import Rosy.Robots.RobotRun (runOnRobotFor)
import Rosy.Robots.Target
import Rosy.Robots.Wording (inTerminal, tellPerson)
import Rosy.Sentence
import System.Directory (doesFileExist)
import System.Environment (getArgs, getExecutablePath, getProgName, lookupEnv)
import System.Exit (ExitCode (..), exitWith)
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
readCommandLine :: String -> [String] -> Either Sentence Invocation
readCommandLine self given = case given of
  [] -> Left (trWith "{which} Where Rosy is, {name} --world room tries it in the simulator." ["which" =@ whichRobot self, "name" =: T.pack self])
  ["--link", number] | Just descriptor <- readMaybe number -> Right (OnLink descriptor)
  _ | any (`elem` ["--help", "-h"]) given -> Right Help
  _ -> options given >>= wanted
  where
    options [] = Right []
    options (word : rest) = case break (== '=') word of
      (name, '=' : value) | name `elem` known -> ((name, value) :) <$> options rest
      _ | word `notElem` known -> Left (trWith "{name} does not take {option}. {name} --help says what there is." ["name" =: T.pack self, "option" =: T.pack word])
      _ -> case rest of
        value : rest' -> ((word, value) :) <$> options rest'
        [] -> Left (trWith "Say what {option} is. {name} --help says what there is." ["option" =: T.pack word, "name" =: T.pack self])
    known = "--robot" : "--seconds" : simulators
    -- What is typed last counts, as for ./rosy run.
    wanted typed = case lookup "--robot" (reverse typed) of
      Nothing -> Right InSimulator
      Just address -> case [name | (name, _) <- typed, name `elem` simulators] of
        name : _ -> Left (trWith "{option} is for the simulator; a real robot cannot have it." ["option" =: T.pack name])
        [] -> OnRobot address <$> traverse seconds (lookup "--seconds" (reverse typed))
    seconds text = case readMaybe (if take 1 text == "." then '0' : text else text) of
      Just s | s >= 0, s <= longest -> Right s
      _ -> Left (trWith "{option} must be between 0 and {most}." ["option" =: "--seconds", "most" =: T.pack (show (round longest :: Int))])

-- | What only a simulated robot has.
simulators :: [String]
simulators = ["--world", "--seed", "--speed", "--trace", "--input"]

-- | Longest run, seconds: a week, as for @./rosy run@.
longest :: Double
longest = 7 * 24 * 3600

whichRobot :: String -> Sentence
whichRobot self = trWith "Say which robot to drive: {name} --robot ws://HOST:9090, ros://HOST:11311 or serial:/dev/kobuki." ["name" =: T.pack self]

-- | What the program says of itself, line by line.
usage :: String -> [Sentence]
usage self =
  [ trWith "{name}: a program for a robot, made by ./rosy build." ["name" =: T.pack self],
    verbatim "",
    tr "  --robot ADDRESS     the robot to drive: ws://HOST:9090, ros://HOST:11311 or serial:/dev/kobuki",
    tr "  --seconds S         how long, in seconds of the robot",
    verbatim "",
    tr "Without --robot it runs in the simulator, where Rosy is, and takes what ./rosy run takes:",
    verbatim "",
    verbatim "  --world NAME|FILE  --seconds S  --seed N  --speed X|max  --trace FILE  --input FILE"
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
    Left why -> refuse why
    Right Help -> mapM_ (inTerminal >=> T.putStrLn) (usage self)
    Right (OnLink descriptor) -> do
      -- The simulator may offer the memory of a mailbox, which a program built earlier does not know.
      memory <- lookupEnv "ROSY_MAILBOX"
      mailbox <- maybe (pure noMailbox) mapMailbox (memory >>= readMaybe)
      onPipe descriptor nullPtr mailbox [] [] program
    Right (OnRobot address seconds) -> onRobot seconds address program
    Right InSimulator -> inSimulator home self given

-- | Drives the robot at an address, whose profile may be a file.
onRobot :: Maybe Double -> String -> IO () -> IO ()
onRobot seconds address program = do
  profile <- try (traverse B.readFile (profileFile address))
  case profile of
    Left e -> refuse (trWith "The robot's profile cannot be read: {why}" ["why" =: T.pack (show (e :: IOException))])
    Right text -> case withFile text address of
      Left e -> refuse (explainTargetError e)
      Right robot -> runOnRobotFor seconds robot program >>= exitWith

-- | Becomes @./rosy run@ of this file. @ROSY_ROOT@ says where Rosy is when it has moved.
inSimulator :: FilePath -> String -> [String] -> IO ()
inSimulator home self given = do
  moved <- lookupEnv "ROSY_ROOT"
  let rosy = fromMaybe home moved ++ "/rosy"
  found <- doesFileExist rosy
  unless found (refuse (trWith "The simulator is a part of Rosy, which is not on this computer. {which}" ["which" =@ whichRobot self]))
  file <- getExecutablePath
  executeFile rosy False ("run" : file : given) Nothing

-- | Ends with a sentence on standard error.
refuse :: Sentence -> IO a
refuse why = tellPerson why >> exitWith (ExitFailure 1)
