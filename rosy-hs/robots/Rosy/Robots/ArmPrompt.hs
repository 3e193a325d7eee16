{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Robots.ArmPrompt
-- Description : Question on the terminal whether a robot that stands may drive again.
--
-- In: the guard of a run, and lines on standard input. Out: sentences on standard error; Enter arms the guard. The question is only asked,
-- and standard input only read, when a robot that was lost is back, or this program was away ('longestAbsence'). Without a keyboard the robot stands until the run ends.
module Rosy.Robots.ArmPrompt
  ( startArmPrompt,
  )
where

import Control.Concurrent (forkIO, threadWaitRead)
import Control.Concurrent.STM
import Control.Exception (IOException, try)
import Control.Monad (forever, void)
import Rosy.Robots.Guard
import Rosy.Robots.Wording (tellPerson)
import Rosy.Sentence
import System.Posix.IO (stdInput)
import System.Posix.Signals (Handler (..), installHandler, sigTTIN)

-- | Asks for the robot of this name, in a thread of its own, until the process ends.
startArmPrompt :: Sentence -> TVar Guard -> IO ()
startArmPrompt name guarded = do
  -- A job in the background that reads from the terminal would be suspended.
  _ <- installHandler sigTTIN Ignore Nothing
  void . forkIO . forever $ do
    atomically (readTVar guarded >>= \g -> check (isConnected g && not (isArmed g)))
    tellPerson (trWith "{robot} stands, because it or this program was away for too long. Press Enter here to let it drive again." ["robot" =@ name])
    -- Waits without blocking the process; getLine alone could not be interrupted.
    try (threadWaitRead stdInput >> getLine) >>= \case
      Right _ -> atomically (modifyTVar' guarded (\g -> if isConnected g then arm g else g))
      Left (_ :: IOException) -> do
        tellPerson (trWith "{robot} stands, because nothing can be typed here. Start the program again, or write rearm=off into the robot's address." ["robot" =@ name])
        atomically (readTVar guarded >>= check . isArmed)
