-- |
-- Description : Generated messages against Debian's genpy: sums, constants and bytes of the same values.
--
-- A user's messages are made beside the library's, compiled as a program in one go, and asked about bytes that genpy wrote. A run takes
-- the message packages below, a nightly run all that Debian has. Where they cannot be had the test says so and passes without having tested.
module Test.Ros.Genpy (tests) where

import Control.Exception (bracket)
import Control.Monad (filterM, unless)
import Data.List (intercalate, nub, sort)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import qualified Data.Set as Set
import Ros.Gen.Files
import Ros.Gen.Haskell
import Ros.Gen.Md5
import Ros.Gen.Msg
import System.Directory
import System.Environment (lookupEnv)
import System.Exit (ExitCode (..))
import System.FilePath (takeDirectory, (</>))
import System.IO
import System.Posix.Temp (mkdtemp)
import System.Process
import Test.Tasty
import Test.Tasty.HUnit

tests :: TestTree
tests = testCaseInfo "messages of Debian's packages are genpy's: sums, constants, bytes both ways" $ do
  isNightly <- (== Just "1") <$> lookupEnv "ROSY_TEST_NIGHTLY"
  prepared <- prepare []
  case prepared of
    Left why -> pure ("skipped: " ++ why)
    Right () -> do
      found <- loadDefinitions roots >>= either assertFailure pure
      let known = definedMessages found
          all' = nub (map package (Map.keys known))
          named = if isNightly then all' else ordinary
      prepare (sort (nub (map package (Map.keys (nestedIn known named))))) >>= either assertFailure pure
      compareAll isNightly found [n | n <- Map.keys known, package n `elem` named]

-- | Where messages are; Debian's text of a message takes the place of the library's.
roots :: [FilePath]
roots = [library, "rosy-hs/test-ros/msg", cache </> "debian/usr/share"]

library, cache :: FilePath
library = "rosy-hs/ros/msg"
cache = ".rosy/ros-messages"

-- | Messages of this test's own, with each kind of field and constant, and packages of Debian's; nightly runs compare all of them.
ordinary :: [String]
ordinary = words "awkward diagnostic_msgs shape_msgs tf2_msgs trajectory_msgs"

prepare :: [String] -> IO (Either String ())
prepare names = do
  (code, out, err) <- readProcessWithExitCode "rosy-hs/test-ros/setup-messages" (cache : names) ""
  pure $ if code == ExitSuccess then Right () else Left (unwords (lines (out ++ err)))

-- | The messages of these packages and all that they nest.
nestedIn :: Messages -> [String] -> Messages
nestedIn known named = grow (Map.filter ((`elem` named) . package . msgName) known)
  where
    grow have =
      let more = Map.fromList [(t, m) | h <- Map.elems have, Field (Nested t) _ _ <- fields h, t `Map.notMember` have, Just m <- [Map.lookup t known]]
       in if Map.null more then have else grow (Map.union have more)

compareAll :: Bool -> Definitions -> [MsgName] -> IO String
compareAll isNightly found names = do
  library' <- loadLibrary [library] >>= either assertFailure pure
  let known = definedMessages found
      ours = definedMessages library'
  seed <- fromMaybe "1" <$> lookupEnv "ROSY_TEST_SEED"
  let services = [n | n <- Set.toList (definedServices found), package n `elem` map package names]
      serviceOf = Map.fromList [(half, n) | n <- Set.toList (definedServices found), let (request, response) = halves n, half <- [request, response]]
  said <- map fieldsOf . lines <$> genpy seed ([unwords (fullName n : [fullName s | Just s <- [Map.lookup n serviceOf]]) | n <- names] ++ [fullName n ++ " service" | n <- services])
  length said @?= length names + length services
  let (expected, sums) = splitAt (length names) said
  [[fullName n, either explainNestingError id (serviceMd5 known (known Map.! request) (known Map.! response))] | n <- services, let { (request, response) = halves n }] @?= sums
  withFolder $ \folder -> do
    texts <- either assertFailure pure (modules library' found (nub (map package names)))
    mapM_ (\(n, text) -> write (folder </> modulePath n) text) texts
    write (folder </> "Main.hs") (mainModule known names)
    build folder
    let asked = [(head facts, value) | facts <- expected, value <- valuesOf facts]
    answered <- map fieldsOf . lines <$> readUtf8 (folder </> "answers") (unlines [unwords [name, bytes] | (name, (bytes, _)) <- asked])
    let wanted = [withoutText ours (take 6 facts ++ [bytes, shown]) | facts <- expected, (bytes, shown) <- valuesOf facts]
        differences = [unlines (head w : ["  expected " ++ e ++ "\n       got " ++ g | (e, g) <- zip w (a ++ repeat "nothing"), e /= g]) | (w, a) <- zip wanted (map (withoutText ours) answered), w /= a]
    length answered @?= length wanted
    unless (null differences) $ assertFailure (show (length differences) ++ " of " ++ show (length wanted) ++ " values differ:\n" ++ concat (take 5 differences))
    let packages = length (nub (map package names))
    if isNightly then assertBool "fewer than 300 messages of ten packages" (length names >= 300 && packages >= 10) else pure ()
    pure (show (length names) ++ " messages of " ++ show packages ++ " packages, " ++ show (length services) ++ " services, " ++ show (length wanted) ++ " values")
  where
    genpy seed asked = do
      folders' <- mapM (\root -> listDirectory root >>= \ps -> pure (map (root </>) (sort ps))) roots
      folders <- concat <$> mapM (\p -> (\kinds -> if null kinds then [p] else map (p </>) kinds) <$> filterM (doesDirectoryExist . (p </>)) ["msg", "srv"]) (concat folders')
      readUtf8With "/usr/bin/python3" (["rosy-hs/test-ros/peers/genpy_values.py", seed, cache </> "python"] ++ folders) (unlines asked)
    valuesOf facts = pairs (drop 6 facts)
    pairs (a : b : rest) = (a, b) : pairs rest
    pairs _ = []
    -- A definition in the library has fewer comments than Debian's, so its text is another one.
    withoutText ours facts = [f | (i, f) <- zip [0 :: Int ..] facts, i /= 5 || take 1 facts `notElem` map (\n -> [fullName n]) (Map.keys ours)]

fieldsOf :: String -> [String]
fieldsOf line = case break (== '\t') line of
  (f, _ : rest) -> f : fieldsOf rest
  (f, []) -> [f]

-- | A program that answers for each of these messages.
mainModule :: Messages -> [MsgName] -> String
mainModule known names =
  unlines $
    ["module Main (main) where", "", "import Data.Proxy (Proxy (..))", "import GenpyAnswers"]
      ++ ["import qualified " ++ moduleName n | n <- names]
      ++ ["", "main :: IO ()", "main = answers ["]
      ++ [intercalate ",\n" [row n m | n <- names, Just m <- [Map.lookup n known]]]
      ++ ["  ]"]
  where
    row n m = "  (" ++ show (fullName n) ++ ", answerTo (Proxy :: Proxy " ++ typeName n ++ ") [" ++ intercalate ", " ["show " ++ moduleName n ++ "." ++ c | (_, c) <- constantNames m] ++ "])"

-- | With the library that cabal has built for this test.
build :: FilePath -> IO ()
build folder = do
  version <- filter (/= '\n') <$> readProcess "ghc" ["--numeric-version"] ""
  description <- readFile "rosy.cabal"
  let own = concat [v | l <- lines description, ["version:", v] <- [words l]]
  (code, out, err) <-
    readProcessWithExitCode "ghc" (["-v0", "-O0", "-dynamic", "-XHaskell2010", "-package-db", "dist-newstyle/packagedb/ghc-" ++ version, "-package-id", "rosy-" ++ own ++ "-inplace-ros"] ++ ["-XScopedTypeVariables", "-i" ++ folder ++ ":rosy-hs/test-ros/peers", "-outputdir", folder </> "objects", "-o", folder </> "answers", folder </> "Main.hs"]) ""
  unless (code == ExitSuccess) $ assertFailure ("the generated modules do not compile:\n" ++ unlines (take 40 (lines (out ++ err))))

withFolder :: (FilePath -> IO a) -> IO a
withFolder = bracket (getTemporaryDirectory >>= \tmp -> mkdtemp (tmp </> "genpy-")) removeDirectoryRecursive

write :: FilePath -> String -> IO ()
write path text = do
  createDirectoryIfMissing True (takeDirectory path)
  withFile path WriteMode $ \h -> hSetEncoding h utf8 >> hPutStr h text

readUtf8 :: FilePath -> String -> IO String
readUtf8 program = readUtf8With program []

-- | What a program prints; it fails with what it says is wrong.
readUtf8With :: FilePath -> [String] -> String -> IO String
readUtf8With program args input = withFolder $ \folder -> do
  write (folder </> "in") input
  code <- withFile (folder </> "in") ReadMode $ \i -> withFile (folder </> "out") WriteMode $ \o -> withCreateProcess (proc program args) {std_in = UseHandle i, std_out = UseHandle o} (\_ _ _ p -> waitForProcess p)
  unless (code == ExitSuccess) $ assertFailure (program ++ " failed")
  withFile (folder </> "out") ReadMode $ \h -> hSetEncoding h utf8 >> hGetContents h >>= \text -> length text `seq` pure text
