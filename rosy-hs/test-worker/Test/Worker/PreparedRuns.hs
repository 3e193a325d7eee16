{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Test.Worker.PreparedRuns
-- Description : Tests of runs that are compiled before they are asked for.
module Test.Worker.PreparedRuns (tests) where

import Control.Monad (forM, forM_, replicateM, void, when)
import Data.Aeson (Value (..), object, toJSON, (.=))
import qualified Data.Aeson.KeyMap as KeyMap
import Data.List (nub, sort)
import Data.Text (Text)
import qualified Data.Text as Text
import System.Posix.Signals (sigKILL, signalProcess)
import Test.Tasty (TestTree, testGroup)
import Test.Tasty.HUnit
import Test.Worker.Client

megabytes :: Int
megabytes = 1024 * 1024

runMemory :: Int
runMemory = 64 * megabytes

tests :: IO Worker -> TestTree
tests borrow =
  testGroup
    "Prepared runs"
    [ testCase "a prepared program is the one that runs, and says what one says that was compiled for its run" $ do
        worker <- borrow
        (child, prepared, said) <- do
          robot <- prepare worker "prepared" several runMemory
          child <- waiting worker
          tell worker (begin "prepared" several runMemory)
          started <- hear worker
          running <- onlyChildOf (processId worker)
          said <- threeSteps robot
          closeLink robot
          gone <- hear worker
          text "op" gone @?= "gone"
          ([child], started, said) <$ (running @?= child)
        (usual, saidUsually) <- withRun worker "usual" several runMemory $ \robot -> (,) <$> hear worker <*> threeSteps robot
        _ <- hear worker
        length child @?= 1
        withoutTimes prepared @?= withoutTimes usual
        said @?= saidUsually,
      testCase "a plain run does the same, and is told without warnings, used types and branches; what does not compile is refused all the same" $ do
        worker <- borrow
        (usual, saidUsually) <- withRun worker "usual" doubtful runMemory $ \robot -> (,) <$> hear worker <*> threeSteps robot
        _ <- hear worker
        (plain, saidPlainly) <- do
          robot <- runPlainly worker "plain" doubtful runMemory
          started <- hear worker
          said <- threeSteps robot
          closeLink robot
          (started, said) <$ hear worker
        forM_ ["problems", "uses", "branches"] $ \name -> assertBool (show usual) (field name usual `notElem` [Null, toJSON ([] :: [Value])])
        map (`field` plain) ["op", "problems", "uses", "branches"] @?= ["started", toJSON ([] :: [Value]), toJSON ([] :: [Value]), Null]
        saidPlainly @?= saidUsually
        robot <- runPlainly worker "wrong" "main = simulate (Velocity True 0)" runMemory
        hear worker >>= (@?= "refused") . text "op"
        closeLink robot,
      testCase "each plain run after the first begins in a process of its own that was forked before, and says the same" $ do
        worker <- borrow
        let plainly name source = do
              robot <- runPlainly worker name source runMemory
              started <- hear worker
              text "op" started @?= "started"
              at <- onlyChildOf (processId worker)
              said <- threeSteps robot
              closeLink robot
              hear worker >>= (@?= "gone") . text "op"
              pure (at, said)
            spares = sparesOf (processId worker)
        (_, first) <- plainly "first" several
        eventually "one waits" ((== 1) . length <$> spares)
        before <- descriptorsOf (processId worker)
        runs <- forM ["second", "third" :: Text] $ \name -> do
          eventually "one waits" ((== 1) . length <$> spares)
          waits <- spares
          -- Its channel, and what it puts in the place of 0, 1 and 2.
          eventually "it has five descriptors" ((== [5]) <$> mapM descriptorsOf waits)
          (at, said) <- plainly (toJSON name) several
          [at] @?= waits
          said @?= first
          pure waits
        assertBool "another process for each" (sort (concat runs) == nub (sort (concat runs)))
        eventually "the next one waits" ((== 1) . length <$> spares)
        eventually "no descriptor is left" ((<= before) <$> descriptorsOf (processId worker))
        -- A long one does not fit into the channel at once, perhaps.
        (_, long') <- plainly "long" (several <> Text.replicate 190 ("-- " <> Text.replicate 999 "." <> "\n"))
        long' @?= first
        -- A spare child that dies is replaced; the run after it is not affected.
        eventually "the next one waits" ((== 1) . length <$> spares)
        lost <- spares
        mapM_ (signalProcess sigKILL . fromIntegral) lost
        eventually "it has ended" (all (`notElem` lost) <$> spares)
        (_, said) <- plainly "after a loss" several
        said @?= first
        eventually "another one waits" ((== 1) . length <$> spares)
        robot <- runPlainly worker "wrong" "main = simulate (Velocity True 0)" runMemory
        hear worker >>= (@?= "refused") . text "op"
        closeLink robot
        eventually "there is another" ((== 1) . length <$> spares)
        killed <- runPlainly worker "killed" bomb runMemory
        eventually "it is at work" ((== 1) . length <$> childrenOf (processId worker))
        gone <- ask worker (kill "killed")
        (text "op" gone, field "signal" gone) @?= ("gone", Number 9)
        closeLink killed,
      testCase "a program that waits has the rights of one that runs: filter, capabilities, priority, descriptors" $ do
        worker <- borrow
        robot <- prepare worker "rights" several runMemory
        child <- waiting worker
        -- Its socket, and its link, beside an empty 0, 1 and 2.
        descriptorsOf child >>= (@?= 5)
        threadStatus "NoNewPrivs" child >>= (@?= ["1"]) . take 1
        threadStatus "CapEff" child >>= assertBool "no capability" . all (all (== '0'))
        -- proc(5), stat: the niceness is field 19.
        stat <- readFile ("/proc/" ++ show child ++ "/stat")
        niceness worker >>= \own -> drop 16 (take 17 (words (drop 2 (dropWhile (/= ')') stat)))) @?= [show (max 5 (own + 5))]
        discard worker "rights" robot,
      testCase "a program that waits has given back the memory that compiling it took" $ do
        worker <- borrow
        robot <- prepare worker "long" (long 12) runMemory
        child <- waiting worker
        own <- privateMemory child
        assertBool (show own ++ " bytes of its own") (own > 0 && own < 6 * megabytes)
        tell worker (begin "long" (long 12) runMemory)
        hear worker >>= (@?= "started") . text "op"
        _ <- oneStep robot
        closeLink robot
        hear worker >>= (@?= "gone") . text "op",
      testCase "two pages prepare, and each has its own" $ do
        worker <- borrow
        robots <- forM ["a", "b" :: Text] $ \n -> prepare worker (toJSON n) (speaking n) runMemory
        eventually "both wait" ((== 2) . length <$> waitingChildren worker)
        forM_ (reverse (zip ["a", "b" :: Text] robots)) $ \(n, robot) -> do
          tell worker (begin (toJSON n) (speaking n) runMemory)
          _ <- answerOf worker (toJSON n)
          said <- oneStep robot
          assertBool (show said) (toJSON ["Say \"" <> n <> "\""] `elem` map (field "commands") said)
          closeLink robot
          gone <- answerOf worker (toJSON n)
          text "op" gone @?= "gone",
      testCase "a run that is asked for while its program is being prepared, or waits to be, starts once" $ do
        worker <- borrow
        robots <- forM [1 .. 4 :: Int] $ \n -> prepare worker (toJSON n) (speaking (Text.pack (show n))) runMemory
        forM_ [4, 3, 2, 1 :: Int] $ \n -> tell worker (begin (toJSON n) (speaking (Text.pack (show n))) runMemory)
        answers <- replicateM 4 (hear worker)
        sort [(text "op" a, text "id" a) | a <- answers] @?= [("started", Text.pack (show (toJSON n))) | n <- [1 .. 4 :: Int]]
        mapM_ closeLink robots
        ends <- replicateM 4 (hear worker)
        map (text "op") ends @?= replicate 4 "gone",
      testCase "a prepared child that was killed costs the run no answer" $ do
        worker <- borrow
        robot <- prepare worker "killed" (speaking "yes") runMemory
        child <- waiting worker
        signalProcess sigKILL (fromIntegral child)
        tell worker (begin "killed" (speaking "yes") runMemory)
        started <- hear worker
        (text "op" started, text "id" started) @?= ("started", "killed")
        said <- oneStep robot
        assertBool (show said) (toJSON ["Say \"yes\"" :: Text] `elem` map (field "commands") said)
        closeLink robot
        hear worker >>= (@?= "gone") . text "op",
      testCase "what is discarded leaves no process, no descriptor and an ended link" $ do
        worker <- borrow
        eventually "nothing is at work" (null <$> childrenOf (processId worker))
        before <- descriptorsOf (processId worker)
        forM_ [1 .. 10 :: Int] $ \n -> do
          robot <- prepare worker (toJSON n) (speaking "no") runMemory
          -- Of every second one the child waits; the others are discarded while they are compiled, or before.
          when (even n) (void (waiting worker))
          discard worker (toJSON n) robot
        eventually "no child is left" (null <$> childrenOf (processId worker))
        eventually "no descriptor is left" ((<= before) <$> descriptorsOf (processId worker)),
      testCase "a program with a mistake is refused when its run is asked for, with the same problems" $ do
        worker <- borrow
        robot <- prepare worker "mistaken" mistake runMemory
        eventually "its child has ended" (null <$> childrenOf (processId worker))
        refused <- ask worker (begin "mistaken" mistake runMemory)
        usual <- withRun worker "usual" mistake runMemory (const (hear worker))
        (text "op" refused, field "problems" refused) @?= ("refused", field "problems" usual)
        listen robot >>= (@?= Nothing),
      testCase "preparing stops while a question is answered, and goes on afterwards" $ do
        worker <- borrow
        robot <- prepare worker "slow" bomb runMemory
        eventually "it is being compiled" ((== ["R"]) . map (take 1) <$> states worker)
        tell worker (check "question" bomb)
        eventually "it is stopped" ((== ["T"]) . map (take 1) <$> states worker)
        answer <- ask worker (kill "question")
        text "op" answer @?= "gone"
        eventually "it goes on" ((== ["R"]) . map (take 1) <$> states worker)
        discard worker "slow" robot,
      testCase "when the worker is killed, what it has prepared goes" $
        withWorker [] $ \worker -> do
          robot <- prepare worker "orphan" (speaking "no") runMemory
          child <- waiting worker
          signalProcess sigKILL (fromIntegral (processId worker))
          ended worker
          eventually "the prepared child is gone" (not <$> isAlive child)
          closeLink robot,
      testCase "an id is prepared once, and a worker prepares a bounded number" $
        withWorker [] $ \worker -> do
          robot <- prepare worker "twice" (speaking "no") runMemory
          again <- prepare worker "twice" (speaking "no") runMemory
          hear worker >>= (@?= "failed") . text "op"
          listen again >>= (@?= Nothing)
          discard worker "twice" robot
          robots <- forM [1 .. 65 :: Int] $ \n -> prepare worker (toJSON n) bomb runMemory
          refused <- hear worker
          (text "op" refused, field "id" refused) @?= ("failed", Number 65)
          mapM_ closeLink robots,
      testCase "what takes too long to prepare is given up, and its run is refused for it" $
        withWorker ["--check-seconds", "0.4"] $ \worker -> do
          robot <- prepare worker "long" bomb runMemory
          -- Requests are read in their order: after this answer the first one is being compiled, or was given up already.
          _ <- ask worker (check "question" mistake)
          eventually "it was given up" (null <$> childrenOf (processId worker))
          refused <- ask worker (begin "long" bomb runMemory)
          (text "op" refused, kinds refused) @?= ("refused", ["too-long"])
          closeLink robot,
      testCase "prepared programs are the first to go when memory is short, and run all the same" $
        withWorker ["--check-memory", show (24 * megabytes), "--total-memory", show (48 * megabytes)] $ \worker -> do
          robots <- forM ["a", "b", "c" :: Text] $ \n -> prepare worker (toJSON n) (speaking n) runMemory
          eventually "all wait" ((== 3) . length <$> waitingChildren worker)
          links <- forM [1, 2 :: Int] $ \n -> run worker (toJSON n) (bomb <> "\n-- " <> Text.pack (show n)) runMemory
          refused <- replicateM 2 (hear worker)
          [kinds a | a <- refused] @?= replicate 2 ["too-large"]
          eventually "a prepared one has ended" ((< 3) . length <$> waitingChildren worker)
          forM_ (zip ["a", "b", "c" :: Text] robots) $ \(n, robot) -> do
            tell worker (begin (toJSON n) (speaking n) runMemory)
            started <- answerOf worker (toJSON n)
            text "op" started @?= "started"
            closeLink robot
            gone <- answerOf worker (toJSON n)
            text "op" gone @?= "gone"
          mapM_ closeLink links
    ]
  where
    kinds answer = case field "problems" answer of
      Array ps -> [text "kind" p | p <- foldr (:) [] ps]
      _ -> []
    discard worker i robot = do
      gone <- ask worker (kill i)
      (text "op" gone, field "id" gone, field "signal" gone) @?= ("gone", i, Number 9)
      eventually "its link is closed" ((== Nothing) <$> listen robot)
      closeLink robot
    withoutTimes (Object o) = Object (KeyMap.delete "id" (KeyMap.delete "compile" o))
    withoutTimes v = v
    niceness worker = do
      stat <- readFile ("/proc/" ++ show (processId worker) ++ "/stat")
      pure (read (words (drop 2 (dropWhile (/= ')') stat)) !! 16) :: Int)
    states worker = childrenOf (processId worker) >>= mapM (fmap (concat . take 1) . threadStatus "State")

-- | The only prepared child, once it has compiled its program.
waiting :: Worker -> IO Int
waiting worker = do
  eventually "a prepared child waits" ((== 1) . length <$> waitingChildren worker)
  waitingChildren worker >>= \found -> case found of
    [child] -> pure child
    _ -> fail ("more than one child waits: " ++ show found)

-- | Children under the second filter, which a program has when it begins. proc(5), @Seccomp_filters@.
waitingChildren :: Worker -> IO [Int]
waitingChildren worker = do
  children <- childrenOf (processId worker)
  filters <- mapM (threadStatus "Seccomp_filters") children
  pure [child | (child, count : _) <- zip children filters, count == "2"]

oneStep, threeSteps :: Link -> IO [Value]
oneStep robot = do
  say robot (object ["op" .= ("start" :: Text), "protocol" .= (1 :: Int), "seed" .= (7 :: Int), "trace" .= True])
  ready <- linesUntil "ready" robot
  (ready ++) <$> step robot 0
threeSteps robot = (++) <$> oneStep robot <*> (concat <$> mapM (step robot) [1, 2])

step :: Link -> Int -> IO [Value]
step robot n = do
  say robot (object ["op" .= ("step" :: Text), "step" .= n, "time" .= (fromIntegral n / 50 :: Double)])
  linesUntil "settled" robot

speaking :: Text -> Text
speaking word = "main = simulate (Say \"" <> word <> "\")\n"

-- | Random numbers, a memory and branches.
several :: Text
several = Text.unlines ["main = simulate (wander, count)", "", "wander :: StdGen -> Seconds -> Velocity", "wander gen t", "  | t < 0.03 = Velocity (fst (randomR (0, 1) gen)) 0", "  | otherwise = Velocity 0 1", "", "count :: Seconds -> Memory Int -> Memory Int", "count _ (Memory n) = Memory (n + 1)"]

-- | It has a warning, branches, and a memory.
doubtful :: Text
doubtful = several <> Text.unlines ["", "slow :: Maybe Int -> Int", "slow (Just n) = n"]

-- | Compiling a function of this program allocates some ten megabytes.
long :: Int -> Text
long count =
  Text.unlines $
    ["data Mode = Go | Turn Double Seconds", "main = simulate (" <> Text.intercalate ", " ["step" <> n k | k <- [1 .. min 9 count]] <> ")"]
      ++ concat
        [ [ "step" <> n k <> " :: Bumper -> Memory Mode -> Seconds -> Memory Mode",
            "step" <> n k <> " _ (Memory m) now = Memory (after m)",
            "  where",
            "    after (Turn a t)",
            "      | now > t + " <> n k <> " = Go",
            "      | otherwise = Turn (a * " <> n k <> " / 2) t",
            "    after other = other"
          ]
          | k <- [1 .. count]
        ]
  where
    n = Text.pack . show

mistake :: Text
mistake = "main = simulate move\n\nmove :: Velocity\nmove = Velocity \"fast\" 0\n"

-- | Its types double with every line: no machine has the time or the memory to compile it.
bomb :: Text
bomb = Text.unlines (["main = print (length (show (f30 'x')))", "f0 x = (x, x)"] ++ ["f" <> n k <> " x = f" <> n (k - 1) <> " (f" <> n (k - 1) <> " x)" | k <- [1 .. 30 :: Int]])
  where
    n = Text.pack . show
