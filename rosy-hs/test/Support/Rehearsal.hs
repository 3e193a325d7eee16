{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Support.Rehearsal
-- Description : A robot of paper: runs a program as "Rosy.Run" runs it, and reads the lines that would leave.
--
-- The lines are those of the link, so what is read here is what a simulator or a real robot gets to hear.
module Support.Rehearsal
  ( Cue (..),
    Heard (..),
    End (..),
    rehearse,
  )
where

import Control.Exception
import Control.Monad (unless, when)
import Data.Aeson (Object, (.!=), (.:), (.:?))
import qualified Data.Aeson as Aeson
import Data.Aeson.Types (Parser, parseEither)
import Data.ByteString.Builder (Builder, toLazyByteString)
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.IORef
import Rosy.Channel (Channel (..), Kind (..), Message (..), tellAction)
import Rosy.Core (Interest, Occurrence (Sensed), Program, interestIn, interestedIn, nameText, tickInterest)
import Rosy.Link
import Rosy.Loop (Quiescence (..), neverQuiet)
import Rosy.Problem (Fault (..))
import Rosy.Run (runOn)
import Rosy.Wire (Telling (..), writeAnswer, writeEnding)

-- | What the other end does next.
data Cue
  = -- | Seconds, what was sensed, whether the clock ticks.
    Steps Double [Message] Bool
  | Stops
  | Breaks
  deriving (Show)

-- | What one line says, and at which step's time.
data Heard = Heard {heardAt :: Double, heardCommands :: [String], heardFired :: [String], heardFirings :: [Aeson.Value], heardEnd :: Maybe End}
  deriving (Eq, Show)

-- | How it ended, the kind of the problem, whom it names.
data End
  = End String (Maybe String) (Maybe String)
  | -- | No listener was left to be told.
    Broken
  deriving (Eq, Show)

-- | Nothing happens any more.
data Curtain = Curtain
  deriving (Show)

instance Exception Curtain

-- | Run a program from its first cue to its end, or to the last cue. It must be silent in batches that it has called quiet.
rehearse :: [Cue] -> Program r -> IO [Heard]
rehearse cues program = do
  left <- newIORef cues
  now <- newIORef 0
  heard <- newIORef []
  promised <- newIORef neverQuiet
  isQuiet <- newIORef False
  let hear builder = do
        time <- readIORef now
        modifyIORef' heard (read' time builder :)
      keepsQuiet what = readIORef isQuiet >>= \quiet -> when (quiet && not (null what)) (error ("not silent in a quiet step: " ++ unwords what))
      link =
        Link
          { open = const (pure (Opening 1 0)),
            next = do
              coming <- readIORef left
              case coming of
                [] -> throwIO Curtain
                cue : rest -> do
                  writeIORef left rest
                  case cue of
                    Stops -> pure Nothing
                    Breaks -> throwIO (LinkLost "closed")
                    Steps time messages tick -> do
                      writeIORef now time
                      promise <- readIORef promised
                      writeIORef isQuiet (time < quietUntil promise - 1e-6 && not (any (wakes promise) ([interestIn (Sensed m) | m <- messages] ++ [tickInterest | tick])) && not (any isEvent messages))
                      pure (Just (Batch 0 time messages tick False True False)),
            answer = \a -> do
              keepsQuiet (map nameText (answerFired a) ++ map tellAction (answerActions a))
              writeIORef promised (answerQuiescence a)
              hear (writeAnswer (Telling True False) a),
            end = \a ending -> do
              unless (isStopped ending) (keepsQuiet ["ended"])
              hear (writeEnding (Telling True False) a ending),
            atWork = const (pure ()),
            atRest = pure ()
          }
  outcome <- try (runOn link [] program)
  case outcome of
    Right () -> pure ()
    Left exception
      | Just Curtain <- fromException exception -> pure ()
      | Just (LinkLost _) <- fromException exception -> do
        time <- readIORef now
        modifyIORef' heard (Heard time [] [] [] (Just Broken) :)
      | otherwise -> throwIO exception
  reverse <$> readIORef heard

wakes :: Quiescence -> Interest -> Bool
wakes promise = interestedIn (wakingInterest promise)

-- | A message that ends the quiet whatever the program follows.
isEvent :: Message -> Bool
isEvent (Message channel _) = channelKind channel == EventChannel

isStopped :: Ending -> Bool
isStopped EndedStopped = True
isStopped _ = False

-- | The last of the lines says it all.
read' :: Double -> Builder -> Heard
read' time builder = either (error . ("a line that cannot be read: " ++)) id (Aeson.eitherDecode (last (Lazy.lines (toLazyByteString builder))) >>= parseEither line)
  where
    line :: Object -> Parser Heard
    line o = do
      end' <- o .:? "how"
      Heard time <$> o .: "commands" <*> o .: "fired" <*> o .:? "firings" .!= [] <*> traverse (ending o) end'
    ending o way = do
      problem <- o .:? "problem"
      case problem of
        Nothing -> pure (End way Nothing Nothing)
        Just p -> End way <$> p .:? "kind" <*> p .:? "function"
