-- |
-- Module      : Ros.Gen.Files
-- Description : The generator's command line: which files it reads and writes.
--
-- In: the arguments of @rosy-messages@. Out: Haskell modules on disk and their names on stdout; a
-- sentence on stderr and exit status 1 when a definition cannot be read. It never changes a file
-- whose text is already right, so builds stay quick.
module Ros.Gen.Files
  ( generate,
    modules,
    loadMessages,
  )
where

import Control.Monad (filterM, forM, forM_, unless)
import Data.List (sort)
import qualified Data.Map.Strict as Map
import Ros.Gen.Haskell
import Ros.Gen.Md5
import Ros.Gen.Msg
import System.Directory (createDirectoryIfMissing, doesDirectoryExist, doesFileExist, listDirectory)
import System.Exit (exitFailure)
import System.FilePath (dropExtension, takeDirectory, takeExtension, (</>))
import System.IO (IOMode (..), hGetContents, hPutStr, hPutStrLn, hSetEncoding, stderr, utf8, withFile)

generate :: [String] -> IO ()
generate arguments = case options arguments of
  Just (out, roots, packages@(_ : _)) -> do
    known <- loadMessages roots >>= orFail
    texts <- orFail (modules known packages)
    forM_ texts $ \(name, text) -> do
      writeIfChanged (out </> modulePath name) text
      putStrLn (moduleName name)
  _ -> failWith "usage: rosy-messages -o OUT [-I MSGS]... PACKAGE..."
  where
    options = go ("", [], [])
    go (_, is, ps) ("-o" : o : rest) = go (o, is, ps) rest
    go (o, is, ps) ("-I" : i : rest) = go (o, is ++ [i], ps) rest
    go (o, is, ps) (p : rest) | take 1 p /= "-" = go (o, is, ps ++ [p]) rest
    go (o, is, ps) [] | not (null o) = Just (o, is, ps)
    go _ _ = Nothing

-- | The module of every message of these packages, in the order of their names.
modules :: Messages -> [String] -> Either String [(MsgName, String)]
modules known packages = case filter (`notElem` map package (Map.keys known)) packages of
  absent : _ -> Left ("no messages found for package " ++ absent)
  [] -> forM [m | m <- Map.elems known, package (msgName m) `elem` packages] $ \m -> explain $ do
    s <- md5 known m
    d <- fullDefinition known m
    pure (msgName m, haskellModule s d m)
  where
    explain = either (Left . explainNestingError) Right

loadMessages :: [FilePath] -> IO (Either String Messages)
loadMessages roots = do
  found <- concat <$> mapM inRoot roots
  fmap (fmap messages . sequence) . forM found $ \(name, path) -> do
    text <- readUtf8 path
    pure (either (\e -> Left (path ++ ": " ++ explainMsgError e)) Right (readMsg name text))
  where
    inRoot root = do
      packages <- listDirectory root >>= filterM (doesDirectoryExist . (root </>)) . sort
      concat <$> mapM (inPackage root) packages
    inPackage root p = do
      nested <- doesDirectoryExist (root </> p </> "msg")
      let folder = if nested then root </> p </> "msg" else root </> p
      files <- sort . filter ((== ".msg") . takeExtension) <$> listDirectory folder
      pure [(MsgName p (dropExtension f), folder </> f) | f <- files]

writeIfChanged :: FilePath -> String -> IO ()
writeIfChanged path text = do
  exists <- doesFileExist path
  same <- if exists then (== text) <$> readUtf8 path else pure False
  unless same $ do
    createDirectoryIfMissing True (takeDirectory path)
    withFile path WriteMode $ \h -> hSetEncoding h utf8 >> hPutStr h text

readUtf8 :: FilePath -> IO String
readUtf8 path = withFile path ReadMode $ \h -> do
  hSetEncoding h utf8
  text <- hGetContents h
  length text `seq` pure text

orFail :: Either String a -> IO a
orFail = either failWith pure

failWith :: String -> IO a
failWith message = hPutStrLn stderr message >> exitFailure
