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
    Definitions (..),
    withoutServices,
    loadDefinitions,
    loadLibrary,
    compiledNames,
  )
where

import Control.Monad (filterM, foldM, forM, forM_, join, unless)
import Data.List (sort)
import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import Ros.Gen.Haskell
import Ros.Gen.Md5
import Ros.Gen.Msg
import System.Directory (createDirectoryIfMissing, doesDirectoryExist, doesFileExist, listDirectory)
import System.Exit (exitFailure)
import System.FilePath (dropExtension, takeDirectory, takeExtension, (</>))
import System.IO (IOMode (..), hGetContents, hPutStr, hPutStrLn, hSetEncoding, stderr, utf8, withFile)

generate :: [String] -> IO ()
generate arguments = case options arguments of
  Just (out, roots, libraries, wanted@(_ : _)) -> do
    library <- loadLibrary libraries >>= orFail
    known <- loadDefinitions roots >>= orFail
    texts <- orFail (modules library known wanted)
    forM_ texts $ \(name, text) -> do
      writeIfChanged (out </> modulePath name) text
      putStrLn (moduleName name)
  _ -> failWith "usage: rosy-messages -o OUT [-I MSGS]... [-L MSGS]... PACKAGE[/NAME]..."
  where
    options = go ("", [], [], [])
    go (_, is, ls, ps) ("-o" : o : rest) = go (o, is, ls, ps) rest
    go (o, is, ls, ps) ("-I" : i : rest) = go (o, is ++ [i], ls, ps) rest
    go (o, is, ls, ps) ("-L" : l : rest) = go (o, is, ls ++ [l], ps) rest
    go (o, is, ls, ps) (p : rest) | take 1 p /= "-" = go (o, is, ls, ps ++ [p]) rest
    go (o, is, ls, ps) [] | not (null o) = Just (o, is, ls, ps)
    go _ _ = Nothing

-- | The modules of these packages or single messages and services (@package/Name@), and of all that they nest, in the order of their
-- names. What a library has is not made again: two modules of one name would be two types. The first argument is what the library has,
-- the second all messages on disk.
modules :: Definitions -> Definitions -> [String] -> Either String [(MsgName, String)]
modules (Definitions library offered) (Definitions given services) wanted = case filter (\w -> not (any (`isOf` w) (Map.keys known ++ Set.toList services))) wanted of
  absent : _
    | '/' `elem` absent -> Left ("there is no message or service " ++ absent)
    | otherwise -> Left ("no messages found for package " ++ absent)
  [] -> do
    let asked = [n | n <- Set.toList services, any (n `isOf`) wanted]
        halvesAsked = concat [[request, response] | n <- asked, let (request, response) = halves n]
    named <- foldM nested Map.empty [m | m <- Map.elems known, msgName m `elem` halvesAsked || any (msgName m `isOf`) wanted]
    (++) <$> (concat <$> mapM one (Map.elems named)) <*> mapM service (filter (`Set.notMember` offered) asked)
  where
    known = Map.union given library
    name `isOf` w = w == package name || w == fullName name
    service n
      | n `Map.member` known = Left (fullName n ++ " is the name of a message and of a service; their modules would have one name")
      | otherwise = (\sum5 -> (n, serviceModule sum5 n)) <$> sumOf n
    sumOf n = explained (join (serviceMd5 known <$> half request <*> half response))
      where
        (request, response) = halves n
        half h = maybe (Left (MissingMessage n h)) Right (Map.lookup h known)
    serviceOf = Map.fromList [(half, n) | n <- Set.toList services, let (request, response) = halves n, half <- [request, response]]
    nested done m
      | msgName m `Map.member` done = Right done
      | otherwise = do
        below <- mapM (child m) [t | Field (Nested t) _ _ <- fields m]
        foldM nested (Map.insert (msgName m) m done) below
    child m t = maybe (explained (Left (MissingMessage (msgName m) t))) Right (Map.lookup t known)
    one m = do
      s <- explained (md5 known m)
      case Map.lookup (msgName m) library of
        Nothing -> do
          d <- explained (fullDefinition known m)
          service' <- traverse (\n -> (,) n <$> sumOf n) (Map.lookup (msgName m) serviceOf)
          pure [(msgName m, haskellModule service' s d m)]
        Just theirs -> do
          s' <- explained (md5 (Map.union library given) theirs)
          if s == s' then pure [] else Left (fullName (msgName m) ++ " is in the library already, with other fields or constants; only one of them can be used in a program")
    explained = either (Left . explainNestingError) Right

-- | What folders define: messages, among them the two of each service, and the names of services.
data Definitions = Definitions {definedMessages :: Messages, definedServices :: Set.Set MsgName}

withoutServices :: Messages -> Definitions
withoutServices ms = Definitions ms Set.empty

loadDefinitions :: [FilePath] -> IO (Either String Definitions)
loadDefinitions roots = do
  found <- concat <$> mapM inRoot roots
  parsed <- forM found $ \(name, path) -> do
    text <- readUtf8 path
    pure (either (\e -> Left (path ++ ": " ++ explainMsgError e)) Right (definition name path text))
  pure (Definitions <$> (messages . concat <$> sequence parsed) <*> pure (Set.fromList [n | (n, path) <- found, isService path]))
  where
    definition name path text
      | isService path = readSrv name text >>= \(request, response) -> pure [request, response]
      | otherwise = pure <$> readMsg name text
    isService = (== ".srv") . takeExtension
    inRoot root = do
      packages <- listDirectory root >>= filterM (doesDirectoryExist . (root </>)) . sort
      concat <$> mapM (inPackage root) packages
    inPackage root p = (++) <$> inFolder root p "msg" <*> inFolder root p "srv"
    inFolder root p kind = do
      nested <- doesDirectoryExist (root </> p </> kind)
      let folder = if nested then root </> p </> kind else root </> p
      files <- sort . filter ((== '.' : kind) . takeExtension) <$> listDirectory folder
      pure [(MsgName p (dropExtension f), folder </> f) | f <- files]

-- | What a library has: of a folder with a list 'compiledNames' only what stands there, of another one all.
loadLibrary :: [FilePath] -> IO (Either String Definitions)
loadLibrary roots = fmap (foldr both (withoutServices Map.empty)) . sequence <$> mapM one roots
  where
    one root = do
      listed <- compiledNames root
      found <- loadDefinitions [root]
      pure (maybe id only listed <$> found)
    only names (Definitions ms ss) =
      let kept = Set.filter ((`Set.member` names) . fullName) ss
          parts = Set.fromList (concat [[request, response] | n <- Set.toList kept, let (request, response) = halves n])
       in Definitions (Map.filterWithKey (\n _ -> fullName n `Set.member` names || n `Set.member` parts) ms) kept
    both (Definitions ms ss) (Definitions ms' ss') = Definitions (Map.union ms ms') (Set.union ss ss')

-- | The messages and services of a folder that are compiled into a library: the lines of its @compiled.txt@, where it has one.
compiledNames :: FilePath -> IO (Maybe (Set.Set String))
compiledNames root = do
  exists <- doesFileExist (root </> "compiled.txt")
  if exists then Just . Set.fromList . lines <$> readUtf8 (root </> "compiled.txt") else pure Nothing

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
