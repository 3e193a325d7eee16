-- |
-- Module      : Rosy.Robots.Announce
-- Description : Saying on this machine who drives which robot, so that any other terminal can stop it.
--
-- A file per process in a folder of the user's, named by the process's number, with the robot's address in it, locked as
-- long as the process lives. It gets that name when all of this is so: whoever looks clears files away that nobody has locked.
-- @./rosy estop@ reads the folder and signals who holds a lock (sim-service, estop.py). A folder that
-- cannot be had is no reason not to drive: Ctrl-C and the page still stop the robot.
module Rosy.Robots.Announce
  ( announced,
    folder,
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

-- | Where this user's robots are announced.
folder :: IO FilePath
folder =
  lookupEnv "XDG_RUNTIME_DIR" >>= \case
    Just d | not (null d) -> pure (d ++ "/rosy")
    _ -> (\user -> "/tmp/rosy-" ++ show user) <$> getEffectiveUserID

-- | While the action runs, others know that this process drives the robot at this address.
announced :: String -> IO a -> IO a
announced address act = bracket (try announce) withdraw (const act)
  where
    announce :: IO (FilePath, Fd)
    announce = do
      place <- folder
      createDirectoryIfMissing True place
      setFileMode place ownerModes
      process <- show <$> getProcessID
      let name = place ++ "/" ++ process
          unfinished = place ++ "/." ++ process
      fd <- openFd unfinished ReadWrite (Just 0o600) defaultFileFlags {trunc = True}
      setFdOption fd CloseOnExec True
      setLock fd (WriteLock, AbsoluteSeek, 0, 0)
      void (fdWrite fd (C.unpack (C.pack address)))
      rename unfinished name
      pure (name, fd)
    withdraw :: Either IOException (FilePath, Fd) -> IO ()
    withdraw made = case made of
      Left _ -> pure ()
      Right (name, fd) -> void (try (removeFile name) :: IO (Either IOException ())) >> closeFd fd
