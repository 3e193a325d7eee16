-- |
-- Description : rosy-robot: a real robot for a program that waits for the simulator.
--
-- > rosy-robot ADDRESS DESCRIPTOR [SECONDS]
--
-- The descriptor is a stream socket at whose other end the program waits. What the program says goes to standard output,
-- and behind it a line of JSON about how it ended, as @./rosy run@ prints it; sentences for a person go to standard error.
-- Ctrl-C and the system's request stop the robot at once and the program in good order.
module Main (main) where

import Control.Concurrent (forkIO, threadDelay)
import Control.Concurrent.STM
import Control.Exception (finally)
import Control.Monad (forM_)
import qualified Data.ByteString as B
import qualified Data.Text as T
import qualified Data.Text.IO as T
import GHC.Clock (getMonotonicTime)
import Network.Socket (mkSocket)
import Rosy.Robot (Orientation (..), Position (..))
import Rosy.Robots.Base (Base (..))
import Rosy.Robots.Drive (onSignals, withBase)
import Rosy.Robots.Guard
import Rosy.Robots.Serve
import Rosy.Robots.Target
import System.Environment (getArgs)
import System.Exit
import System.IO (BufferMode (..), hPutStrLn, hSetBuffering, stderr, stdout)

main :: IO ()
main = do
  hSetBuffering stdout LineBuffering
  arguments <- getArgs
  target <- case arguments of
    address : _ : _ -> do
      profile <- traverse B.readFile (profileFile address)
      either (refuse . explainTargetError) pure (withFile profile address)
    _ -> refuse "rosy-robot takes an address, such as ws://HOST:9090, and the descriptor of a socket."
  socket <- case drop 1 arguments of
    n : _ | [(fd, "")] <- reads n -> mkSocket fd
    _ -> refuse "the second argument is the number of a descriptor."
  began <- getMonotonicTime
  stopWanted <- newTVarIO False
  guarded <- newTVarIO (newGuard (targetLimits target) (targetSafety target))
  forM_ [s | [t] <- [drop 2 arguments], (s, "") <- reads t] $ \s ->
    -- A thread's delay is counted in an Int of microseconds: a week fits.
    forkIO (threadDelay (ceiling (s * 1e6 :: Double)) >> atomically (writeTVar stopWanted True))
  served <- withBase target $ \base -> do
    let standing = atomically (stateTVar guarded halting) >>= mapM_ (tell base)
    onSignals (standing >> atomically (writeTVar stopWanted True)) (serve (readTVar stopWanted) (targetPatience target) guarded base socket)
      `finally` standing
  ended <- getMonotonicTime
  report (ended - began) served

refuse :: String -> IO a
refuse why = hPutStrLn stderr ("rosy: " ++ why) >> exitWith (ExitFailure 1)

report :: Double -> Served -> IO ()
report wall served = do
  (word, status) <- case how served of
    ByItself -> pure ("done", ExitSuccess)
    Asked -> pure ("time", ExitSuccess)
    InError message hint -> ("error", ExitFailure 2) <$ mapM_ (T.hPutStrLn stderr) (message : [hint | not (T.null hint)])
    IsStuck -> ("stuck", ExitFailure 2) <$ hPutStrLn stderr "The program was still busy after a second, so the robot was stopped."
    IsDead -> ("error", ExitFailure 2) <$ hPutStrLn stderr "The program has died, so the robot was stopped."
    RobotLost why -> ("error", ExitFailure 2) <$ hPutStrLn stderr ("The robot is gone: " ++ why ++ ".")
  putStrLn $
    ("{\"time\":" ++ show (fromIntegral (stepsServed served) / 50 :: Double) ++ ",\"pose\":" ++ maybe "null" pose (lastPose served))
      ++ (",\"ended\":\"" ++ word ++ "\",\"steps\":" ++ show (stepsServed served) ++ ",\"wall\":" ++ show wall ++ "}")
  exitWith status
  where
    pose (Position x y, Orientation a) = "{\"x\":" ++ show x ++ ",\"y\":" ++ show y ++ ",\"theta\":" ++ show a ++ "}"
