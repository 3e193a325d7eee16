{-# LANGUAGE ForeignFunctionInterface #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Test.Worker.Client
-- Description : Test client: starts the real worker and plays the service.
--
-- Every wait has a limit; a worker that does not answer fails the test.
module Test.Worker.Client
  ( -- * A worker
    Worker (..),
    withWorker,
    forked,
    tell,
    tellBytes,
    hear,
    ask,
    answerOf,
    closeWorker,
    ended,

    -- * Requests
    check,
    run,
    runPlainly,
    prepare,
    begin,
    kill,
    field,
    text,

    -- * Robot links
    Link,
    withRun,
    say,
    listen,
    linesUntil,
    closeLink,

    -- * Looking at processes
    childrenOf,
    onlyChildOf,
    sparesOf,
    allChildrenOf,
    descriptorsOf,
    threadStatus,
    anonymousMemory,
    privateMemory,
    isAlive,
    eventually,
  )
where

import Control.Concurrent (threadDelay, threadWaitWrite)
import Control.Exception (IOException, SomeException, bracket, onException, try)
import Control.Monad (filterM, unless, void)
import Data.Aeson (Value (..), decodeStrict', encode, object, (.=))
import qualified Data.Aeson.Key as Key
import qualified Data.Aeson.KeyMap as KeyMap
import Data.ByteString (ByteString)
import qualified Data.ByteString as ByteString
import qualified Data.ByteString.Char8 as Char8
import qualified Data.ByteString.Lazy as Lazy
import Data.ByteString.Unsafe (unsafeUseAsCStringLen)
import Data.Either (fromRight)
import Data.IORef
import Data.Maybe (fromMaybe, isJust)
import Data.Text (Text)
import qualified Data.Text as Text
import Foreign.C.Error (throwErrnoIfMinus1RetryMayBlock)
import Foreign.C.Types
import Foreign.Ptr (Ptr)
import Network.Socket hiding (listen)
import Network.Socket.ByteString (recv, sendAll)
import System.Directory (findExecutable, listDirectory)
import System.IO (IOMode (ReadMode), openFile)
import System.Posix.IO (FdOption (CloseOnExec), setFdOption)
import System.Posix.Types (Fd (..))
import System.Process
import System.Timeout (timeout)

foreign import ccall safe test_send_with :: CInt -> Ptr CChar -> CULong -> CInt -> IO CLong

data Worker = Worker
  { socketOf :: Socket,
    unread :: IORef ByteString,
    process :: ProcessHandle,
    processId :: Int
  }

-- | A worker with these options, warm.
withWorker :: [String] -> (Worker -> IO a) -> IO a
withWorker options = bracket open shut
  where
    open = do
      (mine, theirs) <- socketPair AF_UNIX Stream defaultProtocol
      Just executable <- findExecutable "rosy-worker"
      withFdSocket mine (\fd -> setFdOption (Fd fd) CloseOnExec True)
      inherited <- socketToFd' theirs
      setFdOption (Fd inherited) CloseOnExec False
      -- With descriptor 0 closed, the first file that the worker opens would get that number.
      nothing <- openFile "/dev/null" ReadMode
      (_, _, _, handle) <- createProcess (proc executable (["--fd", show inherited] ++ options)) {close_fds = False, std_in = UseHandle nothing}
      setFdOption (Fd inherited) CloseOnExec True
      close theirs
      Just pid <- getPid handle
      buffer <- newIORef ""
      let worker = Worker mine buffer handle (fromIntegral pid)
      first <- hear worker
      unless (text "op" first == "ready") (fail ("the worker said " ++ show first))
      pure worker
    shut worker = do
      _ <- try (close (socketOf worker)) :: IO (Either SomeException ())
      ended worker `onException` terminateProcess (process worker)
    socketToFd' s = withFdSocket s pure

-- | Waits for the worker's end.
ended :: Worker -> IO ()
ended worker = eventually "the worker ended" (isJust <$> getProcessExitCode (process worker))

closeWorker :: Worker -> IO ()
closeWorker = close . socketOf

tell :: Worker -> Value -> IO ()
tell worker value = tellBytes worker (Lazy.toStrict (encode value) <> "\n")

tellBytes :: Worker -> ByteString -> IO ()
tellBytes = sendAll . socketOf

-- | The next answer, within four minutes: a busy computer takes long.
hear :: Worker -> IO Value
hear worker = nextLine (socketOf worker) (unread worker) >>= maybe (fail "the worker closed its socket") decoded
  where
    decoded l = maybe (fail ("not JSON: " ++ show l)) pure (decodeStrict' l)

nextLine :: Socket -> IORef ByteString -> IO (Maybe ByteString)
nextLine s buffer = timeout 240000000 go >>= maybe (fail "nothing was said for four minutes") pure
  where
    go = do
      held <- readIORef buffer
      case Char8.elemIndex '\n' held of
        Just n -> Just (ByteString.take n held) <$ writeIORef buffer (ByteString.drop (n + 1) held)
        Nothing -> do
          more <- fromRight "" <$> (try (recv s 65536) :: IO (Either IOException ByteString))
          if ByteString.null more then pure Nothing else writeIORef buffer (held <> more) >> go

ask :: Worker -> Value -> IO Value
ask worker value = tell worker value >> hear worker

-- | The next answer with this id; others are passed over.
answerOf :: Worker -> Value -> IO Value
answerOf worker i = do
  answer <- hear worker
  if field "id" answer == i then pure answer else answerOf worker i

check :: Value -> Text -> Value
check i source = object ["op" .= ("check" :: Text), "id" .= i, "source" .= source]

kill :: Value -> Value
kill i = object ["op" .= ("kill" :: Text), "id" .= i]

-- | Asks for a run; gives the other end of its link.
run :: Worker -> Value -> Text -> Int -> IO Link
run worker i source memory = do
  mine <- tellWithSocket worker (object ["op" .= ("run" :: Text), "id" .= i, "source" .= source, "memory" .= memory])
  Link mine <$> newIORef ""

-- | The same, of a plain run.
runPlainly :: Worker -> Value -> Text -> Int -> IO Link
runPlainly worker i source memory = do
  mine <- tellWithSocket worker (object ["op" .= ("run" :: Text), "id" .= i, "source" .= source, "memory" .= memory, "plain" .= True])
  Link mine <$> newIORef ""

-- | Has a run prepared; gives the other end of its link.
prepare :: Worker -> Value -> Text -> Int -> IO Link
prepare worker i source memory = do
  mine <- tellWithSocket worker (object ["op" .= ("prepare" :: Text), "id" .= i, "source" .= source, "memory" .= memory])
  Link mine <$> newIORef ""

-- | Asks for a run that was prepared.
begin :: Value -> Text -> Int -> Value
begin i source memory = object ["op" .= ("run" :: Text), "id" .= i, "source" .= source, "memory" .= memory]

-- | A worker that another one has forked, warm.
forked :: Worker -> Value -> IO Worker
forked worker i = do
  mine <- tellWithSocket worker (object ["op" .= ("fork" :: Text), "id" .= i])
  buffer <- newIORef ""
  answer <- hear worker
  case (text "op" answer, field "pid" answer) of
    ("forked", Number pid) -> do
      let new = worker {socketOf = mine, unread = buffer, processId = truncate pid}
      first <- hear new
      unless (text "op" first == "ready") (fail ("the forked worker said " ++ show first))
      pure new
    _ -> fail ("the worker said " ++ show answer)

-- | Sends a request with one end of a new socket pair; gives the other end.
tellWithSocket :: Worker -> Value -> IO Socket
tellWithSocket worker request = do
  (mine, theirs) <- socketPair AF_UNIX Stream defaultProtocol
  mapM_ (`withFdSocket` (\fd -> setFdOption (Fd fd) CloseOnExec True)) [mine, theirs]
  let line = Lazy.toStrict (encode request) <> "\n"
  sent <- withFdSocket (socketOf worker) $ \to -> withFdSocket theirs $ \descriptor ->
    -- The socket does not block: while its buffer is full, nothing is sent.
    throwErrnoIfMinus1RetryMayBlock
      "sendmsg"
      (unsafeUseAsCStringLen line (\(bytes, size) -> test_send_with to bytes (fromIntegral size) descriptor))
      (threadWaitWrite (Fd to))
  tellBytes worker (ByteString.drop (fromIntegral sent) line)
  mine <$ close theirs

field :: Text -> Value -> Value
field name (Object o) = fromMaybe Null (KeyMap.lookup (Key.fromText name) o)
field _ _ = Null

text :: Text -> Value -> Text
text name value = case field name value of
  String s -> s
  other -> Text.pack (show other)

-- | The simulator's end of a robot link.
data Link = Link Socket (IORef ByteString)

withRun :: Worker -> Value -> Text -> Int -> (Link -> IO a) -> IO a
withRun worker i source memory = bracket (run worker i source memory) closeLink

say :: Link -> Value -> IO ()
say (Link s _) value = sendAll s (Lazy.toStrict (encode value) <> "\n")

-- | The next line, or nothing when the program has closed the link.
listen :: Link -> IO (Maybe Value)
listen (Link s buffer) = (>>= decodeStrict') <$> nextLine s buffer

-- | Lines up to and with the first that has this @op@, or the end.
linesUntil :: Text -> Link -> IO [Value]
linesUntil op link = do
  next <- listen link
  case next of
    Nothing -> pure []
    Just l
      | text "op" l == op || text "op" l == "ended" -> pure [l]
      | otherwise -> (l :) <$> linesUntil op link

closeLink :: Link -> IO ()
closeLink (Link s _) = void (try (close s) :: IO (Either SomeException ()))

-- | The processes that a worker has started for runs and not yet buried; those that only answer questions stay, and so does the one for the next plain run.
childrenOf :: Int -> IO [Int]
childrenOf = childrenNamed (`notElem` ["rosy-check\n", "rosy-spare\n"])

-- | The only one of these. A child that was just forked for later has its name a moment later, and counts until then.
onlyChildOf :: Int -> IO Int
onlyChildOf pid = do
  found <- newIORef []
  eventually "one child is at work" $ do
    children <- childrenOf pid
    writeIORef found children
    pure (length children == 1)
  head <$> readIORef found

-- | Those that wait for the next plain run.
sparesOf :: Int -> IO [Int]
sparesOf = childrenNamed (== "rosy-spare\n")

childrenNamed :: (String -> Bool) -> Int -> IO [Int]
childrenNamed fits pid = allChildrenOf pid >>= filterM (fmap fits . nameOf)
  where
    nameOf child = fromRight "" <$> (try (readFile ("/proc/" ++ show child ++ "/comm") >>= \s -> length s `seq` pure s) :: IO (Either IOException String))

allChildrenOf :: Int -> IO [Int]
allChildrenOf pid = do
  found <- try (readFile ("/proc/" ++ show pid ++ "/task/" ++ show pid ++ "/children") >>= \s -> length s `seq` pure s) :: IO (Either IOException String)
  pure (either (const []) (map read . words) found)

descriptorsOf :: Int -> IO Int
descriptorsOf pid = length <$> listDirectory ("/proc/" ++ show pid ++ "/fd")

-- | A field of each thread of a process; none when it has ended. proc(5), @/proc/pid/task/tid/status@.
threadStatus :: String -> Int -> IO [String]
threadStatus name pid = (try (listDirectory tasks) :: IO (Either IOException [FilePath])) >>= fmap concat . mapM ofThread . fromRight []
  where
    tasks = "/proc/" ++ show pid ++ "/task"
    ofThread thread = do
      found <- try (readFile (tasks ++ "/" ++ thread ++ "/status") >>= \s -> length s `seq` pure s) :: IO (Either IOException String)
      pure [value | l <- either (const []) lines found, (key, ':' : rest) <- [break (== ':') l], key == name, value <- take 1 (words rest)]

-- | Bytes of memory of a process that no file backs; 0 when it has ended. proc(5), @statm@, in pages of 4 kB.
anonymousMemory :: Int -> IO Int
anonymousMemory pid = do
  found <- try (readFile ("/proc/" ++ show pid ++ "/statm") >>= \s -> length s `seq` pure s) :: IO (Either IOException String)
  pure (case words (fromRight "" found) of _ : resident : shared : _ -> (read resident - read shared) * 4096; _ -> 0)

-- | Bytes of memory that a process shares with no other. proc(5), @smaps_rollup@, in kB.
privateMemory :: Int -> IO Int
privateMemory pid = do
  found <- readFile ("/proc/" ++ show pid ++ "/smaps_rollup")
  pure (sum [read kB * 1024 | key : kB : _ <- map words (lines found), key `elem` ["Private_Clean:", "Private_Dirty:"]])

-- | Whether a process has not ended. A zombie has: one whose parent is gone stays in @/proc@ until the init process has reaped it.
-- proc(5), @/proc/pid/stat@: the state follows the name.
isAlive :: Int -> IO Bool
isAlive pid = do
  stat <- fromRight "" <$> (try (readFile ("/proc/" ++ show pid ++ "/stat") >>= \s -> length s `seq` pure s) :: IO (Either IOException String))
  pure (case drop 1 (words (dropWhile (/= ')') stat)) of state : _ -> state `notElem` ["Z", "X"]; [] -> False)

-- | Waits for something that happens outside, looking every millisecond for at least four minutes.
eventually :: String -> IO Bool -> IO ()
eventually what condition = go (240000 :: Int)
  where
    go 0 = fail ("did not come to pass: " ++ what)
    go n = do
      yes <- condition
      unless yes (threadDelay 1000 >> go (n - 1))
