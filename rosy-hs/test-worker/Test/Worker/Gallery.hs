{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Test.Worker.Gallery
-- Description : Tests of the gallery of mistakes and their explanations.
--
-- Each folder of @gallery@ has a program with a mistake and the expected explanations. UPDATE_GOLDENS=1 rewrites them and the gallery page; read
-- the difference before you commit it.
module Test.Worker.Gallery (tests) where

import Control.Monad (forM, when)
import Data.Aeson (Value (..), eitherDecodeFileStrict', object, toJSON, (.=))
import qualified Data.Aeson as Aeson
import qualified Data.Aeson.KeyMap as KeyMap
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (isDigit, isUpper)
import Data.Foldable (toList)
import Data.List (sort, sortOn)
import Data.Maybe (isJust)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.IO as Text
import Data.Version (versionBranch)
import System.Directory (doesDirectoryExist, listDirectory)
import System.Environment (lookupEnv)
import System.FilePath ((</>))
import System.Info (compilerVersion)
import Test.Tasty (TestTree, testGroup)
import Test.Tasty.HUnit
import Test.Worker.Client
import Test.Worker.PrettyJson (pretty)

tests :: IO Worker -> IO TestTree
tests start = do
  names <- folders
  pure $
    testGroup
      "Gallery of mistakes"
      [ testGroup "says what is expected" [testCase name (judged start name) | name <- names],
        testGroup "is mended by what is offered" [testCase name (mended start name) | name <- names],
        testCase "has at least forty mistakes" (assertBool (show (length names)) (length names >= 40)),
        testCase "is shown on its page" (start >>= \w -> page w names)
      ]

gallery :: FilePath
gallery = "rosy-hs/test-worker/gallery"

folders :: IO [FilePath]
folders = do
  found <- sort <$> listDirectory gallery
  map fst . filter snd <$> forM found (\f -> (,) f <$> doesDirectoryExist (gallery </> f))

updating :: IO Bool
updating = isJust <$> lookupEnv "UPDATE_GOLDENS"

-- | What is said about a program, without GHC's own words: those change with its version.
said :: Worker -> FilePath -> IO [Value]
said worker name = do
  source <- Text.readFile (gallery </> name </> "Main.hs")
  tell worker (check (toJSON name) source)
  answer <- answerOf worker (toJSON name)
  pure [Object (KeyMap.delete "ghc" p) | Object p <- elements (field "problems" answer)]

elements :: Value -> [Value]
elements (Array xs) = toList xs
elements _ = []

judged :: IO Worker -> FilePath -> Assertion
judged start name = do
  worker <- start
  problems <- said worker name
  assertBool "nothing was said" (not (null problems))
  mapM_ plainWords problems
  mapM_ translatable problems
  let file = gallery </> name </> "expected.json"
      answer = object ["problems" .= problems]
  update <- updating
  if update
    then Lazy.writeFile file (pretty answer)
    else do
      expected <- eitherDecodeFileStrict' file
      either assertFailure (if isReference then (@?= answer) else (\e -> sentences answer @?= sentences e)) expected

-- | The gallery holds what is said with GHC 9.0. Newer versions underline other columns, and list other patterns that are missing; what is
-- said on which line is the same (scripts/mistakes.py counts it).
isReference :: Bool
isReference = versionBranch compilerVersion == [9, 0]

-- | The line and the ids of the two sentences of each problem, in order of lines.
sentences :: Value -> [(Text, Text, Text, Text)]
sentences answer = sort [(text "kind" p, Text.pack (show (field "line" (field "start" p))), idOf "message" p, idOf "hint" p) | p <- elements (field "problems" answer)]
  where
    idOf name p = case field "id" (field name (field "sentences" p)) of
      String t -> Text.dropWhileEnd (== '.') (fst (Text.breakOn ", and for" t))
      _ -> ""

-- | Each fix, done, leaves the program without the problem that it is for, and with no error of a kind that it had not before; of a single mistake,
-- with no error but the same mistake elsewhere.
mended :: IO Worker -> FilePath -> Assertion
mended start name = do
  worker <- start
  source <- Text.readFile (gallery </> name </> "Main.hs")
  problems <- said worker name
  sequence_
    [ do
        let now = edited (elements (field "edits" fix)) source
        tell worker (check (toJSON (name ++ " mended")) now)
        left <- elements . field "problems" <$> answerOf worker (toJSON (name ++ " mended"))
        assertBool
          (Text.unpack (text "title" fix <> " leaves the problem:\n" <> now))
          (about problem `notElem` map about left)
        let isNew p = if length problems == 1 then (text "kind" p, text "message" p) `notElem` map (\b -> (text "kind" b, text "message" b)) problems else text "kind" p `notElem` map (text "kind") problems
            new = [p | p <- left, text "severity" p == "error", isNew p, not (leavesHole fix && text "kind" p == "hole")]
        assertBool
          (Text.unpack (text "title" fix <> " brings another error: " <> Text.unwords [text "kind" p <> ": " <> text "message" p | p <- new] <> "\n" <> now))
          (null new)
      | problem <- problems,
        fix <- elements (field "fixes" problem)
    ]
  where
    -- The same mistake may be made again elsewhere.
    about p = (text "kind" p, text "message" p, field "start" p)
    -- What is still to be chosen is a hole, and is said to be one.
    leavesHole fix = any (Text.isInfixOf "_" . text "text") (elements (field "edits" fix))

-- | A text after edits, done from its end.
edited :: [Value] -> Text -> Text
edited edits source = foldr one source (sortOn (place "start") edits)
  where
    one e t = let (before, rest) = Text.splitAt (at "start" e) t in before <> text "text" e <> Text.drop (at "end" e - at "start" e) rest
    at which e = let (l, c) = place which e in sum (map ((+ 1) . Text.length) (take (l - 1) (Text.splitOn "\n" source))) + c - 1
    place which e = let p = field which e in (whole (field "line" p), whole (field "column" p))
    whole v = case Aeson.fromJSON v of
      Aeson.Success n -> n :: Int
      Aeson.Error e -> error e

-- | What every sentence keeps to.
plainWords :: Value -> Assertion
plainWords problem = do
  let message = text "message" problem
      hint = text "hint" problem
      wordsOf = map (Text.filter (`notElem` (".,:;!?()" :: String))) . Text.words . Text.toLower
      jargon = ["instance", "instances", "constraint", "parse", "monad", "applicative", "kind", "polymorphic", "unify", "rigid", "typeclass", "scope", "token", "lexical", "ambiguous"] :: [Text]
  assertBool ("one sentence: " ++ show message) (Text.takeEnd 1 message == "." && Text.length message < 110)
  assertBool ("one sentence or none: " ++ show hint) (Text.length hint < 110 || ": " `Text.isInfixOf` hint)
  assertBool ("a full stop behind code, which is copied with it: " ++ show hint) (not (endsInCode hint))
  assertBool ("begins like a sentence: " ++ show message) (maybe False (\(c, _) -> isUpper c || c == '‘') (Text.uncons message))
  mapM_ (\w -> assertBool ("jargon: " ++ show w) (w `notElem` wordsOf message && w `notElem` wordsOf hint)) jargon

-- | Whether the last word before a full stop is a number, or has a sign that no word of prose has: @drive 50.@, @Just (f x).@
endsInCode :: Text -> Bool
endsInCode hint = case reverse . Text.words <$> Text.stripSuffix "." hint of
  Just (w : _) -> Text.all isDigit w || Text.any (`elem` ("()[]{}=\"+*/" :: String)) w
  _ -> False

-- | Every sentence has an id, which other languages translate. A text without a translation has none, such as a compiler's own.
translatable :: Value -> Assertion
translatable problem = do
  let sentences = field "sentences" problem
  mapM_ (\name -> assertBool ("no id: " ++ show (text name problem)) (Text.null (text name problem) || hasId (field name sentences))) ["message", "hint"]
  mapM_ (\fix -> assertBool ("no id: " ++ show (text "title" fix)) (hasId (field "sentence" fix))) (elements (field "fixes" problem))
  where
    hasId s = case field "id" s of
      String t -> not (Text.null t)
      _ -> False

-- | The page of all mistakes.
page :: Worker -> [FilePath] -> Assertion
page worker names = do
  shown <- forM names $ \name -> do
    source <- Text.readFile (gallery </> name </> "Main.hs")
    problems <- said worker name
    pure (Text.unlines (["## " <> Text.replace "-" " " (Text.pack name), "```haskell", Text.stripEnd source, "```"] ++ map entry problems))
  let whole = Text.unlines (heading ++ shown)
      file = gallery </> "README.md"
  update <- updating
  if update
    then Text.writeFile file whole
    else when isReference $ Text.readFile file >>= \now -> assertBool "the page is old: run with UPDATE_GOLDENS=1" (now == whole)
  where
    heading =
      [ "# Mistakes, and what is said about them",
        "",
        "**In:** a folder for each mistake: `Main.hs`, the program; `expected.json`, what is said. **Out:** this page, written by the tests from what the worker says.",
        "**Never:** edited by hand: change a program or a sentence, run the tests with `UPDATE_GOLDENS=1`, and read the difference.",
        ""
      ]
    entry p =
      "> **" <> text "message" p <> "** " <> text "hint" p <> "  \n> <sub>" <> text "severity" p <> " `" <> text "kind" p <> "`" <> at p <> owner p <> offers p <> "</sub>\n"
    offers p = case map (text "title") (elements (field "fixes" p)) of
      [] -> ""
      titles -> "; offers: " <> Text.intercalate " · " titles
    at p = case (field "start" p, field "end" p) of
      (s@(Object _), e@(Object _)) -> ", " <> spot s <> " to " <> spot e
      _ -> ""
    spot v = shownNumber (field "line" v) <> ":" <> shownNumber (field "column" v)
    owner p = case field "function" p of
      String f -> ", in `" <> f <> "`"
      _ -> ""
    shownNumber v = Text.pack (filter (/= '"') (show (Aeson.encode v)))
