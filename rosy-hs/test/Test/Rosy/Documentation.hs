-- |
-- Module      : Test.Rosy.Documentation
-- Description : Every name that the library exports is explained, and every module opens with what it is for.
--
-- Haddock (part of GHC) says what it misses; names of other packages are explained there.
module Test.Rosy.Documentation (tests) where

import Control.Monad (filterM)
import Data.List (isInfixOf, isPrefixOf, sort)
import System.Directory (doesDirectoryExist, listDirectory)
import System.Exit (ExitCode (..))
import System.FilePath (takeExtension, (</>))
import System.Process (readProcessWithExitCode)
import Test.Tasty (TestTree, testGroup)
import Test.Tasty.HUnit

tests :: TestTree
tests =
  testGroup
    "Documentation"
    [ explained,
      testCase "opens every module with its purpose" $ do
        files <- sources "rosy-hs/src"
        texts <- mapM readFile files
        [file | (file, text) <- zip files texts, not (any ("-- Description : " `isPrefixOf`) (lines text))] @?= []
    ]

explained :: TestTree
explained = testCase "explains every exported name" $ do
  files <- sources "rosy-hs/src"
  (code, out, err) <- readProcessWithExitCode "haddock" (["--no-warnings", "--optghc=-irosy-hs/src", "--optghc=-w"] ++ files) ""
  assertEqual err ExitSuccess code
  assertBool "haddock looked at the modules" (length (filter ("% (" `isInfixOf`) (lines out)) >= length files)
  [name | name <- missing (lines out), takeWhile (/= ' ') name `notElem` others] @?= []
  where
    -- Names that come from base and random.
    others = ["Alternative", "Generic", "Random", "RandomGen", "StdGen", "Typeable", "mkStdGen", "random", "randomR", "randomRs", "randoms", "split"]

-- | The names that haddock lists as undocumented.
missing :: [String] -> [String]
missing ls = case break ("Missing documentation for:" `isInfixOf`) ls of
  (_, []) -> []
  (_, _ : rest) -> let (names, others) = span ("    " `isPrefixOf`) rest in map (dropWhile (== ' ')) names ++ missing others

-- | All Haskell files in a folder.
sources :: FilePath -> IO [FilePath]
sources folder = do
  entries <- map (folder </>) . sort <$> listDirectory folder
  folders <- filterM doesDirectoryExist entries
  inner <- concat <$> mapM sources folders
  pure ([e | e <- entries, takeExtension e == ".hs"] ++ inner)
