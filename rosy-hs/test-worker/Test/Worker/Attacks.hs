{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Test.Worker.Attacks
-- Description : Programs that mean harm, with every protection on and with each one off.
--
-- Each file of @attacks@ runs in the real worker: with all layers, then with one layer less at a time. In none of these may it read the
-- secret file, leave a file, hit another process or outlive its run. UPDATE_GOLDENS=1 writes the table of what became of it.
module Test.Worker.Attacks (tests) where

import Control.Concurrent (forkIO, newEmptyMVar, putMVar, takeMVar)
import Control.Exception (IOException, SomeException, bracket, throwIO, try)
import Control.Monad (forM, forM_, unless, when, (>=>))
import Data.Aeson (Value (..), object, toJSON, (.=))
import qualified Data.ByteString as ByteString
import Data.List (isPrefixOf, isSuffixOf, sort, transpose)
import Data.Maybe (isJust)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.IO as Text
import System.Directory (doesPathExist, listDirectory, removePathForcibly)
import System.Environment (lookupEnv, setEnv)
import System.FilePath (dropExtension, (</>))
import System.Process (createProcess, getPid, getProcessExitCode, proc, terminateProcess, waitForProcess)
import Test.Tasty (TestTree, testGroup)
import Test.Tasty.HUnit
import Test.Worker.Client
import Test.Worker.Life (odometry, start)

tests :: TestTree
tests =
  testGroup
    "Attacks"
    [ testCase "there are at least sixty" $ do
        names <- programs
        assertBool (show (length names)) (length names >= 60),
      testCase "none does harm, whichever layer is missing" $ do
        names <- programs
        setEnv "ROSY_TEST_SECRET" (Text.unpack secret)
        columns <- forM layers $ \(_, options) -> withWorker (options ++ ["--check-seconds", "5"]) $ \worker -> do
          outcomes <- concat <$> mapM (attacked worker) (chunksOf 32 names)
          eventually "no program is left" (null <$> childrenOf (processId worker))
          answer <- ask worker (check "still there" "main = pure ()\n")
          text "op" answer @?= "checked"
          pure outcomes
        let table = transpose (map Text.pack names : columns)
            harmful = [Text.intercalate " " row | row <- table, "HARM" `elem` row]
        update <- isJust <$> lookupEnv "UPDATE_GOLDENS"
        when update (Text.writeFile (folder </> "README.md") (page table))
        assertEqual "harm was done" [] harmful
    ]

folder :: FilePath
folder = "rosy-hs/test-worker/attacks"

programs :: IO [FilePath]
programs = sort . map dropExtension . filter (".hs" `isSuffixOf`) <$> listDirectory folder

layers :: [(Text, [String])]
layers =
  [ ("all layers", []),
    ("without language", ["--without", "language"]),
    ("without system calls", ["--without", "system-calls"]),
    ("without limits", ["--without", "limits"])
  ]

secret :: Text
secret = "rosy-secret-4711"

-- | What became of some programs that run at the same time, each with a secret to read, a file to make and a process to hit.
attacked :: Worker -> [FilePath] -> IO [Text]
attacked worker names =
  bracket (createProcess (proc "sleep" ["600"])) (\(_, _, _, p) -> terminateProcess p >> waitForProcess p) $ \(_, _, _, victim) -> do
    Just victimId <- getPid victim
    let canary = "/tmp/rosy-attack-canary-" ++ show victimId
        target = "/tmp/rosy-attack-target-" ++ show victimId
        aimed = Text.replace "CANARY" (Text.pack canary) . Text.replace "TARGET" (Text.pack target) . Text.replace "VICTIM" (Text.pack (show victimId))
    Text.writeFile canary secret
    links <- forM names $ \name -> do
      source <- Text.readFile (folder </> name ++ ".hs")
      run worker (toJSON name) (aimed source) (64 * 1024 * 1024)
    first <- answersUntil (\answers -> all (\n -> any (of' n) answers) names) []
    heard <- together . flip map (zip names links) $ \(name, link) ->
      if any (\x -> of' name x && text "op" x == "started") first
        then do
          -- It may be gone already.
          _ <- try (say link start >> say link odometry >> say link (object ["op" .= ("step" :: Text), "step" .= (0 :: Int), "time" .= (0 :: Double)])) :: IO (Either IOException ())
          Just <$> everythingFor (patience name) link
        else pure Nothing
    forM_ names (tell worker . kill . toJSON)
    let started = [n | (n, Just _) <- zip names heard]
    answers <- answersUntil (\got -> all (\n -> any (\x -> of' n x && text "op" x == "gone") got) started) first
    mapM_ closeLink links
    let outcomes =
          [ maybe (text "op" (head (filter (of' n) answers))) (\bytes -> became bytes (head [x | x <- answers, of' n x, text "op" x == "gone"])) said
            | (n, said) <- zip names heard
          ]
    alive <- (== Nothing) <$> getProcessExitCode victim
    left <- doesPathExist target
    kept <- (== secret) <$> Text.readFile canary
    unless (alive && not left && kept) (assertFailure ("among " ++ show names ++ " one hit a process or changed a file"))
    removePathForcibly canary
    removePathForcibly target
    pure outcomes
  where
    of' name answer = field "id" answer == toJSON name
    answersUntil enough got
      | enough got = pure got
      | otherwise = hear worker >>= \x -> answersUntil enough (got ++ [x])

-- | Microseconds in which a program may do its worst before it is ended. Nothing is claimed about how long it takes.
patience :: FilePath -> Int
patience name = if "memory" `isPrefixOf` name then 8000000 else 1500000

tried :: IO a -> IO (Either SomeException a)
tried = try

-- | All at once, each in a thread of its own.
together :: [IO a] -> IO [a]
together actions = do
  results <- forM actions $ \action -> do
    result <- newEmptyMVar
    _ <- forkIO (tried action >>= putMVar result)
    pure result
  forM results (takeMVar >=> either throwIO pure)

became :: ByteString.ByteString -> Value -> Text
became said gone
  | any (`ByteString.isInfixOf` said) ["rosy-secret-4711", "HARM"] = "HARM"
  | has "\"kind\":\"memory\"" || field "problem" gone /= Null = "memory"
  | has "\"how\":\"error\"" = "error"
  | has "\"op\":\"settled\"" || has "\"how\":\"done\"" = "ran"
  | field "signal" gone == Number 9 = "stopped"
  | otherwise = "died"
  where
    has t = t `ByteString.isInfixOf` said

chunksOf :: Int -> [a] -> [[a]]
chunksOf _ [] = []
chunksOf n xs = take n xs : chunksOf n (drop n xs)

page :: [[Text]] -> Text
page table =
  Text.unlines $
    [ "# Programs that mean harm",
      "",
      "**In:** a program a file; `CANARY` stands for a secret file, `TARGET` for a file to make, `VICTIM` for a process to hit. **Out:** this table, written by the tests.",
      "**Never:** edited by hand: run the tests with `UPDATE_GOLDENS=1`.",
      "",
      "*refused*: it does not compile. *error*: an exception ended it. *memory*: its limit ended it. *stopped*: it did not settle and was ended, as the service does. *died*: it ended itself.",
      "*ran*: it did what it wanted to, which was harmless.",
      "",
      "| program | " <> Text.intercalate " | " (map fst layers) <> " |",
      "|---|" <> Text.replicate (length layers) "---|"
    ]
      ++ ["| " <> Text.intercalate " | " row <> " |" | row <- table]
