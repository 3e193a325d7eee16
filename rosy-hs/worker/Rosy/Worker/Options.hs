-- |
-- Module      : Rosy.Worker.Options
-- Description : Command line options, and the default location of the library.
module Rosy.Worker.Options
  ( Options (..),
    parseOptions,
    usage,
    findLibrary,
  )
where

import Data.List (isPrefixOf, isSuffixOf, sort, sortOn)
import Data.Word (Word64)
import Rosy.Worker.ChildProcess (Protections (..), allProtections)
import Rosy.Worker.Ghc (Library (..))
import System.Directory (doesDirectoryExist, listDirectory)
import System.Environment (getExecutablePath)
import System.FilePath (takeDirectory, (</>))
import System.Posix.Types (Fd)
import System.Process (readProcess)
import Text.Read (readMaybe)

data Options = Options
  { socketFd :: Fd,
    databases :: [FilePath],
    unit :: Maybe String,
    libdir :: Maybe FilePath,
    enabledProtections :: Protections,
    checkSeconds :: Double,
    checkMemory :: Word64,
    checkLimit :: Int,
    -- | Bytes of memory of all children; half of the machine's when it is not given.
    totalMemory :: Maybe Word64,
    runCpu :: Word64
  }

usage :: String
usage =
  unlines
    [ "rosy-worker [--fd N] [--package-db DIR] [--rosy-unit ID] [--libdir DIR]",
      "            [--check-seconds S] [--check-memory BYTES] [--total-memory BYTES] [--checks N]",
      "            [--run-seconds S]",
      "            [--without language|lists|system-calls|limits|memory|processes|files|computing|privileges]",
      "Serves one Unix stream socket, descriptor 3 unless told otherwise. See protocol/README.md, section 3."
    ]

parseOptions :: [String] -> Either String Options
parseOptions = go (Options 3 [] Nothing Nothing allProtections 10 (512 * 1024 * 1024) 2 Nothing 3600)
  where
    go o arguments = case arguments of
      [] -> Right o
      "--fd" : n : rest | Just fd <- readMaybe n -> go o {socketFd = fromIntegral (fd :: Int)} rest
      "--package-db" : d : rest -> go o {databases = databases o ++ [d]} rest
      "--rosy-unit" : u : rest -> go o {unit = Just u} rest
      "--libdir" : d : rest -> go o {libdir = Just d} rest
      "--check-seconds" : n : rest | Just x <- readMaybe n, x > 0 -> go o {checkSeconds = x} rest
      "--check-memory" : n : rest | Just x <- readMaybe n -> go o {checkMemory = x} rest
      "--total-memory" : n : rest | Just x <- readMaybe n, x > 0 -> go o {totalMemory = Just x} rest
      "--checks" : n : rest | Just x <- readMaybe n, x > 0 -> go o {checkLimit = x} rest
      "--run-seconds" : n : rest | Just x <- readMaybe n, x > 0 -> go o {runCpu = x} rest
      "--without" : l : rest | Just f <- lookup l protectionNames -> go o {enabledProtections = f (enabledProtections o)} rest
      other : _ -> Left ("rosy-worker does not understand " ++ other ++ ".\n" ++ usage)
    protectionNames =
      [ ("language", \l -> l {language = False}),
        ("lists", \l -> l {lists = False}),
        ("system-calls", \l -> l {systemCalls = False}),
        ("limits", \l -> l {memoryLimit = False, processLimit = False, fileLimit = False, computingLimit = False}),
        ("memory", \l -> l {memoryLimit = False}),
        ("processes", \l -> l {processLimit = False}),
        ("files", \l -> l {fileLimit = False}),
        ("computing", \l -> l {computingLimit = False}),
        ("privileges", \l -> l {noPrivileges = False})
      ]

-- | The library that was named, or the one that was built in place beside this executable, and GHC's directory.
findLibrary :: Options -> IO (Either String Library)
findLibrary options = do
  executable <- getExecutablePath
  ghcDirectory <- maybe (takeWhile (/= '\n') <$> readProcess "ghc" ["--print-libdir"] "") pure (libdir options)
  beside <- if null (databases options) then inPlace executable else pure (databases options)
  named <- maybe (unitIn beside) (pure . Just) (unit options)
  pure $ case named of
    Just u -> Right (Library beside u ghcDirectory)
    Nothing -> Left "The Rosy library was not found: build it, or say where it is with --package-db and --rosy-unit."

-- | cabal keeps executables in dist-newstyle/build/… and databases in dist-newstyle/packagedb/ghc-….
inPlace :: FilePath -> IO [FilePath]
inPlace executable = do
  let above = takeWhile (\d -> takeDirectory d /= d) (iterate takeDirectory executable)
      candidates = [d </> "packagedb" | d <- above, "dist-newstyle" `isSuffixOf` d]
  concat <$> mapM inside candidates
  where
    inside d = do
      there <- doesDirectoryExist d
      if there then map (d </>) . sort . filter ("ghc-" `isPrefixOf`) <$> listDirectory d else pure []

unitIn :: [FilePath] -> IO (Maybe String)
unitIn dirs = do
  files <- concat <$> mapM listDirectory dirs
  -- The package's other libraries and its tests stand beside it, as rosy-0.1.0-inplace-ros.conf and the like.
  pure $ case sortOn length [take (length f - length ".conf") f | f <- sort files, "rosy-" `isPrefixOf` f, ".conf" `isSuffixOf` f] of
    u : _ -> Just u
    [] -> Nothing
