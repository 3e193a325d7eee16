{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Test.Worker.GoldenConversations
-- Description : Golden conversations of the protocol, replayed with the real worker.
--
-- @protocol/goldens/link@: a program of each name runs in the worker, the simulator's lines go in, and the program's lines must equal
-- those of the file. @protocol/goldens/worker@: the service's lines go in; UPDATE_GOLDENS=1 rewrites the worker's lines.
module Test.Worker.GoldenConversations (tests) where

import Control.Exception (bracket)
import Control.Monad (forM, replicateM)
import Data.Aeson (Value (..), eitherDecodeStrict', encode, object, toJSON, (.=))
import qualified Data.Aeson.KeyMap as KeyMap
import qualified Data.ByteString as ByteString
import qualified Data.ByteString.Char8 as Char8
import qualified Data.ByteString.Lazy as Lazy
import Data.List (sort)
import Data.Maybe (isJust)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.IO as Text
import System.Directory (listDirectory)
import System.Environment (lookupEnv)
import System.FilePath (dropExtension, takeExtension, (</>))
import Test.Tasty (TestTree, testGroup)
import Test.Tasty.HUnit
import Test.Worker.Client

tests :: IO Worker -> IO TestTree
tests start = do
  links <- named "protocol/goldens/link"
  programs <- sort . map dropExtension . filter ((== ".hs") . takeExtension) <$> listDirectory "rosy-hs/test-worker/programs"
  pure $
    testGroup
      "Golden conversations"
      [ testGroup "a program in the worker says what the link's goldens say" [testCase name (link start withRun name) | name <- links, name `elem` programs],
        testGroup "so does one that was prepared" [testCase name (link start withPrepared name) | name <- links, name `elem` programs],
        testGroup "the worker says what its goldens say" [testCase name (worker start name requests) | (name, requests) <- conversations]
      ]

named :: FilePath -> IO [String]
named folder = sort . map dropExtension . filter ((== ".jsonl") . takeExtension) <$> listDirectory folder

entries :: FilePath -> IO [(Text, Value)]
entries file = do
  lines' <- Char8.lines <$> ByteString.readFile file
  forM lines' $ \l -> either (assertFailure . ((file ++ ": ") ++)) (\v -> pure (text "from" v, field "line" v)) (eitherDecodeStrict' l)

-- | As 'withRun', of a program that may be compiled before it is asked for.
withPrepared :: Worker -> Value -> Text -> Int -> (Link -> IO a) -> IO a
withPrepared w i source memory action = bracket (prepare w i source memory) closeLink (\robot -> tell w (begin i source memory) >> action robot)

link :: IO Worker -> (Worker -> Value -> Text -> Int -> (Link -> IO ()) -> IO ()) -> String -> Assertion
link start with name = do
  w <- start
  source <- Text.readFile ("rosy-hs/test-worker/programs" </> name ++ ".hs")
  golden <- entries ("protocol/goldens/link" </> name ++ ".jsonl")
  with w (toJSON name) source 67108864 $ \robot -> do
    started <- answerOf w (toJSON name)
    (text "op" started, field "problems" started) @?= ("started", toJSON ([] :: [Value]))
    mapM_ (say robot . snd) (filter ((== "sim") . fst) golden)
    said <- everything robot
    mapM_ (uncurry (assertEqual "line by line")) (zip [l | ("prog", l) <- golden] said)
    length said @?= length (filter ((== "prog") . fst) golden)
  gone <- answerOf w (toJSON name)
  text "op" gone @?= "gone"
  where
    everything robot = listen robot >>= maybe (pure []) (\l -> if text "op" l == "ended" then pure [l] else (l :) <$> everything robot)

-- | What the service says in each conversation. A run brings a link without a listener.
conversations :: [(String, [Value])]
conversations =
  [ ("check", [check (Number 1) accelerate]),
    ("mistake", [check (Number 1) mistake]),
    ("complete", [object ["op" .= ("complete" :: Text), "id" .= (5 :: Int), "source" .= ("play :: Bumper -> Maybe Sound\nplay (Bumper _ ) = Nothing\n\nmain = simulate play\n" :: Text), "line" .= (2 :: Int), "column" .= (16 :: Int)]]),
    ("run", [running 2 idle]),
    ("prepare", [preparing 7 idle, running 7 idle]),
    ("refused", [running 3 mistake]),
    ("ping", [object ["op" .= ("ping" :: Text), "id" .= (6 :: Int)]]),
    ("failed", [object ["op" .= ("dance" :: Text), "id" .= (4 :: Int)]])
  ]
  where
    running = toRun "run"
    preparing = toRun "prepare"
    toRun op i source = object ["op" .= (op :: Text), "id" .= (i :: Int), "source" .= (source :: Text), "memory" .= (67108864 :: Int)]
    accelerate = Text.unlines ["main = simulate (accelerate, play)", "", "accelerate :: Velocity -> Velocity", "accelerate (Velocity v w) = Velocity (v + 0.5) w", "", "play :: Bumper -> Maybe Sound", "play (Bumper _ Pressed) = Just ErrorSound", "play _ = Nothing"]
    mistake = "main = simulate move\n\nmove :: Velocity\nmove = Velocity \"fast\" 0\n"
    idle = "main = pure ()\n"

worker :: IO Worker -> String -> [Value] -> Assertion
worker start name requests = do
  w <- start
  let prepared = [field "id" request | request <- requests, text "op" request == "prepare"]
  spoken <- fmap concat . forM requests $ \request -> do
    answers <- case text "op" request of
      "prepare" -> [] <$ prepare w (field "id" request) (text "source" request) 67108864
      "run" | field "id" request `elem` prepared -> tell w request >> replicateM 2 (hear w)
      "run" -> withRun w (field "id" request) (text "source" request) 67108864 $ \_ -> do
        first <- hear w
        if text "op" first == "started" then (\second -> [first, second]) <$> hear w else pure [first]
      _ -> (: []) <$> ask w request
    pure (("service", request) : map ((,) "worker" . steady) answers)
  let file = "protocol/goldens/worker" </> name ++ ".jsonl"
      ready = ("worker", object ["op" .= ("ready" :: Text), "protocol" .= (1 :: Int), "ghc" .= ("9.0.2" :: Text)])
      conversation = ready : spoken
  update <- isJust <$> lookupEnv "UPDATE_GOLDENS"
  if update
    then Lazy.writeFile file (Lazy.concat [encode (object ["from" .= (from :: Text), "line" .= l]) <> "\n" | (from, l) <- conversation])
    else do
      golden <- entries file
      map (fmap wordless) conversation @?= map (fmap wordless) golden
  where
    -- Times differ from machine to machine.
    steady (Object o) | Just _ <- KeyMap.lookup "compile" o = Object (KeyMap.insert "compile" (Number 0.01) o)
    steady v = v
    -- GHC's own words differ from version to version.
    wordless v = case v of
      Object o -> Object (fmap wordless (KeyMap.delete "ghc" o))
      Array xs -> Array (fmap wordless xs)
      _ -> v
