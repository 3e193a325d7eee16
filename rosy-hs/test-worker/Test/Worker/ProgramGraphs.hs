{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Test.Worker.ProgramGraphs
-- Description : Tests of the graph of a program: golden files that the page reads as well.
--
-- Each example, and each program of @protocol/goldens/graphs@, has its graph beside the latter; UPDATE_GOLDENS=1 rewrites them.
module Test.Worker.ProgramGraphs (tests) where

import Control.Monad (filterM)
import Data.Aeson (Value (..), decodeStrict', object, (.=))
import qualified Data.ByteString as ByteString
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (toList)
import Data.List (sort)
import Data.Maybe (isJust)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.IO as Text
import System.Directory (doesFileExist, listDirectory)
import System.Environment (lookupEnv)
import System.FilePath (takeBaseName, takeExtension, (<.>), (</>))
import Test.Tasty (TestTree, testGroup)
import Test.Tasty.HUnit
import Test.Worker.Client
import Test.Worker.PrettyJson (pretty)

tests :: IO Worker -> IO TestTree
tests borrow = do
  own <- filter ((== ".hs") . takeExtension) <$> listDirectory goldens
  examples <- filterM (\e -> doesFileExist ("examples" </> e </> "Main.hs")) =<< listDirectory "examples"
  let programs = sort ([(takeBaseName f, goldens </> f) | f <- own] ++ [(e, "examples" </> e </> "Main.hs") | e <- examples])
  pure $
    testGroup
      "The graph of a program"
      [ testGroup "is that of its golden file" [testCase name (golden borrow name file) | (name, file) <- programs],
        testCase "has a limit where definitions use one another many times" $ do
          worker <- borrow
          found <- partsOf worker doubling
          let size = length (show found)
          assertBool (show size) (size > 1000 && size < 2000000),
        testCase "ends where tasks use one another in a circle" $ do
          worker <- borrow
          found <- partsOf worker "ping :: Task ()\nping = wait 1 >> pong\n\npong :: Task ()\npong = wait 1 >> ping\n\nmain = simulate ping\n"
          assertBool (show found) ("\"ping\"" `Text.isInfixOf` Text.pack (show found)),
        testCase "is empty where a program has a mistake" $ do
          worker <- borrow
          found <- partsOf worker "main = simulate (Velocity True 0)\n"
          found @?= Array mempty,
        testCase "has the topics of a program with a mistake as well, with the names that are known before it runs" $ do
          worker <- borrow
          let namesOf source = map (field "name") . elements . field "topics" . field "graph" <$> ask worker (check (Number 1) source)
          joined <- namesOf (levelOn "place ++ \"/core\"" <> "main = simulate (Velocity True 0)\n")
          joined @?= [String "/kitchen/core"]
          computed <- namesOf (levelOn "reverse place" <> "main = simulate (Velocity 1 0)\n")
          computed @?= [Null]
      ]

goldens :: FilePath
goldens = "protocol/goldens/graphs"

golden :: IO Worker -> String -> FilePath -> IO ()
golden borrow name file = do
  worker <- borrow
  source <- Text.readFile file
  found <- graphOf worker source
  updating <- isJust <$> lookupEnv "UPDATE_GOLDENS"
  let stored = goldens </> name <.> "json"
  if updating
    then Lazy.writeFile stored (pretty found)
    else do
      expected <- decodeStrict' <$> ByteString.readFile stored
      expected @?= Just found

-- | The parts, and the topics if there are any.
graphOf :: Worker -> Text -> IO Value
graphOf worker source = do
  graph <- field "graph" <$> ask worker (check (Number 1) source)
  pure (object (("parts" .= field "parts" graph) : ["topics" .= topics | let topics = field "topics" graph, topics /= Array mempty]))

partsOf :: Worker -> Text -> IO Value
partsOf worker source = field "parts" <$> graphOf worker source

elements :: Value -> [Value]
elements v = case v of
  Array xs -> toList xs
  _ -> []

-- | A sensor on a topic whose name is this expression.
levelOn :: Text -> Text
levelOn name =
  Text.unlines
    [ "newtype Level = Level Double",
      "instance Sensor Level where",
      "  sensor = topic (" <> name <> ") \"std_msgs/Float64\" (Level <$> field \"data\")",
      "place = \"kitchen\""
    ]

-- | Twenty definitions, each of which uses the one before twice: a million steps.
doubling :: Text
doubling =
  Text.unlines $
    ["t0 :: Task ()", "t0 = wait 1"]
      ++ concat [["t" <> n <> " :: Task ()", "t" <> n <> " = t" <> before <> " >> t" <> before] | (before, n) <- zip numbers (drop 1 numbers)]
      ++ ["main = simulate t20"]
  where
    numbers = map (Text.pack . show) [0 .. 20 :: Int]
