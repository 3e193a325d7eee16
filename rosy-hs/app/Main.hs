{-# LANGUAGE OverloadedStrings #-}

-- |
-- Description : rosy-robot: a real robot for programs that wait for the simulator.
--
-- > rosy-robot [--record FILE] ADDRESS DESCRIPTOR [SECONDS [STEP]]
-- > rosy-robot hold ADDRESS DESCRIPTOR [STEP ALIVE]
-- > rosy-robot check ADDRESS
--
-- The first drives for one program: the descriptor is a stream socket at whose other end it waits. What the program says goes to
-- standard output, and behind it a line of JSON about how it ended, as @./rosy run@ prints it; sentences for a person go to
-- standard error. The second holds the robot for one program after another (@protocol/README.md@ section 7): requests come on
-- standard input, lines go to standard output, and the programs' sockets arrive over the descriptor. The third only says whether the
-- address can be one. STEP is how many seconds a program may take for a step, ALIVE after how many seconds without a sign of its owner a
-- run ends.
--
-- Ctrl-C and the system's request stop the robot at once and the program in good order. SIGUSR1 is the emergency stop.
module Main (main) where

import Control.Concurrent (forkIO)
import Control.Concurrent.STM
import Control.Exception (finally)
import Control.Monad (unless, void)
import qualified Data.ByteString as B
import qualified Data.ByteString.Char8 as C
import qualified Data.ByteString.Lazy as L
import Data.Foldable (traverse_)
import Data.Maybe (listToMaybe)
import qualified Data.Text as T
import qualified Data.Text.IO as T
import Foreign.C.Types (CInt)
import GHC.Clock (getMonotonicTime)
import Network.Socket (Socket, mkSocket, recvFd)
import Rosy.Robot (Orientation (..), Position (..))
import Rosy.Robots.ArmPrompt (startArmPrompt)
import Rosy.Robots.Connection (Connection (..), neverRan, sendNow)
import Rosy.Robots.DriverLock (withDriverLock)
import Rosy.Robots.Guard
import Rosy.Robots.LinkRecorder (beginRecording, recordLines, recordedConnection, withRecorder)
import Rosy.Robots.LockstepRun
import Rosy.Robots.RobotProcess
import Rosy.Robots.RobotRun (onSignals, sayUnreadable, terminationSignals, withConnection)
import Rosy.Robots.Target
import Rosy.Robots.Wording (inTerminal, tellPerson)
import Rosy.Sentence
import System.Environment (getArgs)
import System.Exit
import System.IO hiding (withFile)
import System.IO.Error (catchIOError)
import System.Posix.IO (FdOption (..), setFdOption)
import System.Posix.Signals (Handler (..), installHandler, sigUSR1)
import System.Posix.Types (Fd (..))

main :: IO ()
main = do
  -- Writes whole lines, so that concurrent output does not mix.
  mapM_ (`hSetBuffering` LineBuffering) [stdout, stderr]
  -- Sentences have letters that the encoding of the locale may lack.
  mapM_ (`hSetEncoding` utf8) [stdout, stderr]
  getArgs >>= \case
    "hold" : address : fd : given -> holdFor address fd (limitsFrom given)
    ["check", address] -> void (targetAt address)
    "--record" : file : address : fd : given -> driveOnce (Just file) address fd (numbers (take 1 given)) (limitsFrom (drop 1 given))
    address : fd : given -> driveOnce Nothing address fd (numbers (take 1 given)) (limitsFrom (drop 1 given))
    _ -> refuse (tr "rosy-robot takes an address, such as ws://HOST:9090, and the descriptor of a socket.")

targetAt :: String -> IO Target
targetAt address = do
  profile <- traverse B.readFile (profileFile address)
  either (refuse . explainTargetError) pure (withFile profile address)

socketAt :: String -> IO Socket
socketAt text = case reads text of
  [(fd, "")] -> socketFrom fd
  _ -> refuse (tr "the second argument is the number of a descriptor.")

socketFrom :: CInt -> IO Socket
socketFrom fd = setFdOption (Fd fd) NonBlockingRead True >> mkSocket fd

-- | A step's limit and the owner's; without them the defaults.
limitsFrom :: [String] -> ProcessLimits
limitsFrom given = case numbers given of
  step : alive : _ -> ProcessLimits step alive
  step : _ -> defaultLimits {stepLimit = step}
  [] -> defaultLimits

numbers :: [String] -> [Double]
numbers given = [s | t <- given, (s, "") <- reads t]

driveOnce :: Maybe FilePath -> String -> String -> [Double] -> ProcessLimits -> IO ()
driveOnce recording address fd seconds limits = do
  target <- targetAt address
  socket <- socketAt fd
  began <- getMonotonicTime
  stopWanted <- newTVarIO False
  guarded <- newTVarIO (targetGuard target)
  pace <- realPace (stepLimit limits)
  served <- withDriverLock address . withConnection target $ \plain -> withRecorder $ \recorder -> do
    traverse_ (beginRecording recorder) recording
    let connection = recordedConnection recorder plain
        observer = (onTerminal (connectionName connection)) {onLines = recordLines recorder}
    startArmPrompt (connectionName connection) guarded
    let sendHalt = sendNow connection (stateTVar guarded haltWheels)
    onSignals terminationSignals (sendHalt >> atomically (writeTVar stopWanted True)) (runLockstep pace observer (readTVar stopWanted) (listToMaybe seconds) (targetPatience target) guarded connection socket)
      `finally` (sendHalt >> sayUnreadable connection)
  ended <- getMonotonicTime
  report limits (ended - began) served

-- | Until the service closes our input.
holdFor :: String -> String -> ProcessLimits -> IO ()
holdFor address fd limits = do
  target <- targetAt address
  socket <- socketAt fd
  requests <- newRequests
  hSetBinaryMode stdout True
  _ <- forkIO ((reading requests `catchIOError` const (pure ())) `finally` request requests Leave)
  _ <- installHandler sigUSR1 (Catch (request requests EmergencyStop)) Nothing
  withDriverLock address . withConnection target $ \connection -> withRecorder $ \recorder ->
    onSignals (filter (/= sigUSR1) terminationSignals) (request requests Leave) (runRobotProcess limits target recorder connection requests (recvFd socket >>= socketFrom) (\l -> L.hPut stdout l >> hFlush stdout))
  where
    reading requests = do
      over <- isEOF
      unless over $ do
        C.hGetLine stdin >>= mapM_ (request requests) . readRequest
        reading requests

refuse :: Sentence -> IO a
refuse why = inTerminal why >>= T.hPutStrLn stderr . ("rosy: " <>) >> exitWith (ExitFailure 1)

report :: ProcessLimits -> Double -> LockstepResult -> IO ()
report limits wall served = do
  (word, status) <- case runEnd served of
    Finished -> pure ("done", ExitSuccess)
    Stopped -> pure ("time", ExitSuccess)
    Failed message hint _ -> ("error", ExitFailure 2) <$ mapM_ tellPerson (message : [hint | not (T.null (english hint))])
    Stuck -> ("stuck", ExitFailure 2) <$ tellPerson (trWith "The program was still busy after {seconds} seconds, so the robot was stopped." ["seconds" =: T.pack (shownSeconds (stepLimit limits))])
    Died -> ("error", ExitFailure 2) <$ tellPerson (tr "The program has died, so the robot was stopped.")
    -- The observer has said why.
    RobotRefused _ -> pure ("error", ExitFailure 2)
    NeverRan -> ("error", ExitFailure 2) <$ tellPerson neverRan
    RobotLost why -> ("error", ExitFailure 2) <$ tellPerson (trWith "The robot is gone: {why}." ["why" =@ why])
  putStrLn $
    ("{\"time\":" ++ show (fromIntegral (stepsRun served) / 50 :: Double) ++ ",\"pose\":" ++ maybe "null" pose (lastPose served))
      ++ (",\"ended\":\"" ++ word ++ "\",\"steps\":" ++ show (stepsRun served) ++ ",\"wall\":" ++ show wall ++ "}")
  exitWith status
  where
    shownSeconds s = if s == fromIntegral (round s :: Int) then show (round s :: Int) else show s
    pose (Position x y, Orientation a) = "{\"x\":" ++ show x ++ ",\"y\":" ++ show y ++ ",\"theta\":" ++ show a ++ "}"
