{-# LANGUAGE TemplateHaskellQuotes #-}

-- |
-- Module      : Ros.Logging
-- Description : Messages for people, on the terminal and on @/rosout@.
--
-- > enableLogging (Just Warn)
-- > liftIO $(logInfo "no wall in sight")
--
-- Each carries the place in the program that wrote it. What is less grave than the level that @~set_logger_level@ has set is not logged.
module Ros.Logging
  ( enableLogging,
    LogLevel (..),

    -- * Texts that are known when the program is compiled
    logDebug,
    logInfo,
    logWarn,
    logError,
    logFatal,

    -- * Other texts
    Logger,
    logTo,
  )
where

import Control.Concurrent.STM
import Control.Monad (unless, when)
import Data.IORef (IORef, newIORef, readIORef, writeIORef)
import qualified Data.Map.Strict as Map
import Data.Maybe (listToMaybe)
import Data.Time.Clock.POSIX (getPOSIXTime)
import GHC.Stack (CallStack, HasCallStack, SrcLoc (..), callStack, getCallStack)
import Language.Haskell.TH (Exp, Q)
import Ros.LogLevel (LogLevel (..))
import Ros.Message (def, fromSeconds)
import Ros.Names (Naming (..))
import Ros.Node
import Ros.Node.Core (Core (..))
import qualified Ros.Rosgraph_msgs.Log as Log
import Ros.Std_msgs.Header (Header (..))
import System.IO (hPutStrLn, stderr)
import System.IO.Unsafe (unsafePerformIO)

data Logger = Logger Core (Publisher Log.Log) (Maybe LogLevel)

-- | Opens @/rosout@ for this node. Messages of this level or a graver one are also printed, none with 'Nothing': information on the output,
-- warnings and worse on the error stream. The splices below write to the node of a process that has come here last.
enableLogging :: Maybe LogLevel -> Node Logger
enableLogging printed = do
  out <- publisherWith publisherOptions {latched = True} "/rosout"
  logger <- (\core -> Logger core out printed) <$> askCore
  logger <$ liftIO (writeIORef processLogger (Just logger))

-- | Splices of type @IO ()@.
logDebug, logInfo, logWarn, logError, logFatal :: String -> Q Exp
logDebug text = [|logHere Debug text|]
logInfo text = [|logHere Info text|]
logWarn text = [|logHere Warn text|]
logError text = [|logHere Error text|]
logFatal text = [|logHere Fatal text|]

-- | Where the splices write to: they have no argument for it.
processLogger :: IORef (Maybe Logger)
processLogger = unsafePerformIO (newIORef Nothing)
{-# NOINLINE processLogger #-}

-- | Before a node logs, warnings and errors are printed and other messages are dropped.
logHere :: HasCallStack => LogLevel -> String -> IO ()
logHere level text = readIORef processLogger >>= maybe (printFrom (Just Warn) level text) (\logger -> say callStack logger level text)

logTo :: HasCallStack => Logger -> LogLevel -> String -> IO ()
logTo = say callStack

say :: CallStack -> Logger -> LogLevel -> String -> IO ()
say stack (Logger core out printed) level text =
  readTVarIO (logLevel core) >>= \least -> unless (level < least) $ do
    now <- getPOSIXTime
    topics <- Map.keys <$> readTVarIO (publications core)
    printFrom printed level text
    publish out (place def {Log._header = def {_stamp = fromSeconds (realToFrac now)}, Log._level = number level, Log._name = ownName (coreNaming core), Log._msg = text, Log._topics = topics})
  where
    place l = case getCallStack stack of
      (_, at) : around -> l {Log._file = srcLocFile at, Log._line = fromIntegral (srcLocStartLine at), Log._function = maybe "" fst (listToMaybe around)}
      [] -> l
    number l = case l of
      Debug -> Log.debug
      Info -> Log.info
      Warn -> Log.warn
      Error -> Log.error
      Fatal -> Log.fatal

printFrom :: Maybe LogLevel -> LogLevel -> String -> IO ()
printFrom least level text = when (maybe False (level >=) least) $ if level > Info then hPutStrLn stderr (show level ++ ": " ++ text) else putStrLn text
