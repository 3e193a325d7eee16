{-# LANGUAGE CPP #-}

-- |
-- Module      : Rosy.Robots.DriverLock
-- Description : Lock files that name the robots which processes on this machine drive.
--
-- A file per process in a folder of the user's, named by the process's number, with the robot's address in it, locked as
-- long as the process lives. It gets that name when all of this is so: a reader clears files away that are not locked.
-- @./rosy estop@ reads the folder and signals who holds a lock (sim-service, estop.py). A folder that
-- cannot be had is no reason not to drive: Ctrl-C and the page still stop the robot.
module Rosy.Robots.DriverLock
  ( withDriverLock,
    driverLockFolder,
  )
where

import Control.Exception (IOException, bracket, try)
import Control.Monad (void)
import qualified Data.ByteString.Char8 as C
import System.Directory (createDirectoryIfMissing, removeFile)
import System.Environment (lookupEnv)
import System.IO (SeekMode (..))
import System.Posix.Files (ownerModes, rename, setFileMode)
import System.Posix.IO
import System.Posix.Process (getProcessID)
import System.Posix.Types (Fd)
import System.Posix.User (getEffectiveUserID)

-- | Folder of this user's lock files.
driverLockFolder :: IO FilePath
driverLockFolder =
  lookupEnv "XDG_RUNTIME_DIR" >>= \case
    Just d | not (null d) -> pure (d ++ "/rosy")
    _ -> (\user -> "/tmp/rosy-" ++ show user) <$> getEffectiveUserID

-- | Holds a lock file for the robot at this address while the action runs.
withDriverLock :: String -> IO a -> IO a
withDriverLock address act = bracket (try announce) withdraw (const act)
  where
    announce :: IO (FilePath, Fd)
    announce = do
      place <- driverLockFolder
      createDirectoryIfMissing True place
      setFileMode place ownerModes
      process <- show <$> getProcessID
      let name = place ++ "/" ++ process
          unfinished = place ++ "/." ++ process
      fd <- createPrivate unfinished
      setFdOption fd CloseOnExec True
      setLock fd (WriteLock, AbsoluteSeek, 0, 0)
      void (fdWrite fd (C.unpack (C.pack address)))
      rename unfinished name
      pure (name, fd)
    withdraw :: Either IOException (FilePath, Fd) -> IO ()
    withdraw made = case made of
      Left _ -> pure ()
      Right (name, fd) -> void (try (removeFile name) :: IO (Either IOException ())) >> closeFd fd

-- | Creates or empties a file that only its owner can read. The type of openFd differs between versions of unix.
createPrivate :: FilePath -> IO Fd
#if MIN_VERSION_unix(2,8,0)
createPrivate file = openFd file ReadWrite defaultFileFlags {creat = Just 0o600, trunc = True}
#else
createPrivate file = openFd file ReadWrite (Just 0o600) defaultFileFlags {trunc = True}
#endif
