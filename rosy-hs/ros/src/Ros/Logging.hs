-- |
-- Module      : Ros.Logging
-- Description : Messages for people, on the terminal and on @/rosout@.
--
-- Each carries the place in the program that wrote it. Warnings and worse also go to the terminal's
-- error stream, information to its output, as in other nodes; debug messages to @/rosout@ alone. What is less grave than the
-- level that @~set_logger_level@ has set is not logged.
module Ros.Logging
  ( Logger,
    enableLogging,
    LogLevel (..),
    logDebug,
    logInfo,
    logWarn,
    logError,
    logFatal,
  )
where

import Control.Concurrent.STM
import Control.Monad (unless, when)
import qualified Data.Map.Strict as Map
import Data.Maybe (listToMaybe)
import Data.Time.Clock.POSIX (getPOSIXTime)
import GHC.Stack (HasCallStack, SrcLoc (..), callStack, getCallStack)
import Ros.LogLevel (LogLevel (..))
import Ros.Message (def, fromSeconds)
import Ros.Names (Naming (..))
import Ros.Node
import Ros.Node.Core (Core (..))
import qualified Ros.Rosgraph_msgs.Log as Log
import Ros.Std_msgs.Header (Header (..))
import System.IO (hPutStrLn, stderr)

data Logger = Logger Core (Publisher Log.Log)

-- | Opens @/rosout@ for this node. The log functions then work anywhere, also in handlers.
enableLogging :: Node Logger
enableLogging = Logger <$> askCore <*> publisherWith publisherOptions {latched = True} "/rosout"

logDebug, logInfo, logWarn, logError, logFatal :: HasCallStack => Logger -> String -> IO ()
logDebug = say Debug
logInfo = say Info
logWarn = say Warn
logError = say Error
logFatal = say Fatal

say :: HasCallStack => LogLevel -> Logger -> String -> IO ()
say level (Logger core out) text =
  readTVarIO (logLevel core) >>= \least -> unless (level < least) $ do
    now <- getPOSIXTime
    topics <- Map.keys <$> readTVarIO (publications core)
    when (level == Info) (putStrLn text)
    when (level > Info) (hPutStrLn stderr (show level ++ ": " ++ text))
    publish out (place def {Log._header = def {_stamp = fromSeconds (realToFrac now)}, Log._level = number level, Log._name = ownName (coreNaming core), Log._msg = text, Log._topics = topics})
  where
    place l = case drop 1 (getCallStack callStack) of
      (_, at) : around -> l {Log._file = srcLocFile at, Log._line = fromIntegral (srcLocStartLine at), Log._function = maybe "" fst (listToMaybe around)}
      [] -> l
    number l = case l of
      Debug -> Log.debug
      Info -> Log.info
      Warn -> Log.warn
      Error -> Log.error
      Fatal -> Log.fatal
