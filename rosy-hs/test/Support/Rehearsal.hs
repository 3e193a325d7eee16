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
import Data.Aeson (Object, (.!=), (.:), (.:?))
import qualified Data.Aeson as Aeson
import Data.Aeson.Types (Parser, parseEither)
import Data.ByteString.Builder (Builder, toLazyByteString)
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.IORef
import Rosy.Channel (Message)
import Rosy.Core (Program)
import Rosy.Link
import Rosy.Problem (Fault (..))
import Rosy.Run (runOn)
import Rosy.Wire (writeAnswer, writeEnding)

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

-- | Run a program from its first cue to its end, or to the last cue.
rehearse :: [Cue] -> Program r -> IO [Heard]
rehearse cues program = do
  left <- newIORef cues
  now <- newIORef 0
  heard <- newIORef []
  let hear builder = do
        time <- readIORef now
        modifyIORef' heard (read' time builder :)
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
                      pure (Just (Batch 0 time messages tick False True)),
            answer = hear . writeAnswer True,
            end = \a ending -> hear (writeEnding True a ending),
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
