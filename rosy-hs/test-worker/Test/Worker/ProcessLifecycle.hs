{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Test.Worker.ProcessLifecycle
-- Description : Tests of starting, ending and cleaning up child processes.
module Test.Worker.ProcessLifecycle (tests) where

import Control.Concurrent (forkIO, killThread, threadDelay)
import Control.Exception (IOException, evaluate, try)
import Control.Monad (forM, forM_, forever, replicateM, replicateM_)
import Data.Aeson (Value (..), object, toJSON, (.=))
import qualified Data.ByteString as ByteString
import Data.Either (fromRight)
import Data.IORef (modifyIORef', newIORef, readIORef)
import Data.List (sort)
import Data.Text (Text)
import qualified Data.Text as Text
import System.Environment (lookupEnv)
import System.Posix.Signals (sigABRT, sigKILL, signalProcess)
import Test.Tasty (TestTree, testGroup)
import Test.Tasty.HUnit
import Test.Worker.Client

megabytes :: Int
megabytes = 1024 * 1024

tests :: IO Worker -> TestTree
tests borrow =
  testGroup
    "Life of a worker"
    [ testCase "many runs leave no process and no descriptor" $ do
        worker <- borrow
        -- Forty runs, two hundred nightly: one process or descriptor that each leaves would be seen after ten.
        isNightly <- (== Just "1") <$> lookupEnv "ROSY_TEST_NIGHTLY"
        eventually "nothing is at work" (null <$> childrenOf (processId worker))
        before <- descriptorsOf (processId worker)
        forM_ [1 .. if isNightly then 20 else 4 :: Int] $ \batch -> do
          links <- replicateM 10 (run worker (toJSON batch) idle (64 * megabytes))
          answers <- replicateM 20 (hear worker)
          sort (map (text "op") answers) @?= replicate 10 "gone" ++ replicate 10 "started"
          mapM_ closeLink links
        eventually "no child is left" (null <$> childrenOf (processId worker))
        eventually "no descriptor is left" ((<= before) <$> descriptorsOf (processId worker)),
      testCase "a forked worker serves its own socket, shares the memory of the first, and its end is told" $
        withWorker [] $ \worker -> do
          new <- forked worker "second"
          [checked, other] <- forM [new, worker] (`ask` check (Number 1) "main = simulate (Velocity 0.1 0)\n")
          (text "op" checked, field "problems" checked) @?= ("checked", toJSON ([] :: [Value]))
          checked @?= other
          own <- privateMemory (processId new)
          whole <- anonymousMemory (processId worker)
          assertBool (show (own, whole)) (own * 4 < whole)
          gone <- ask worker (kill "second")
          (text "op" gone, text "id" gone, field "signal" gone) @?= ("gone", "second", Number 9),
      testCase "a run can be ended while it compiles" $ do
        worker <- borrow
        withRun worker "bomb" bomb (64 * megabytes) $ \_ -> do
          eventually "a child compiles" (not . null <$> childrenOf (processId worker))
          answer <- ask worker (kill "bomb")
          (text "op" answer, field "signal" answer) @?= ("gone", Number 9),
      testCase "a run can be ended while it runs, and the function at work is named" $ do
        worker <- borrow
        withRun worker "stuck" stuck (64 * megabytes) $ \link -> do
          started <- hear worker
          text "op" started @?= "started"
          firstStep link
          -- The child sits in a loop without an end: it never says that it has settled.
          eventually "the child computes" (or <$> (childrenOf (processId worker) >>= mapM hasWorked))
          gone <- ask worker (kill "stuck")
          (text "op" gone, field "signal" gone, text "firing" gone) @?= ("gone", Number 9, "forEver"),
      testCase "a check can be ended, also while it waits for its turn" $ do
        worker <- borrow
        forM_ ["a", "b", "c", "d" :: Text] (\i -> tell worker (check (toJSON i) (bomb <> "\n-- " <> i)))
        forM_ ["d", "c", "b", "a" :: Text] (tell worker . kill . toJSON)
        answers <- replicateM 4 (hear worker)
        sort (map (text "id") answers) @?= ["a", "b", "c", "d"]
        map (text "op") answers @?= replicate 4 "gone",
      testCase "what takes too long to check is told so" $
        withWorker ["--check-seconds", "0.4"] $ \worker -> do
          answer <- ask worker (check (Number 1) bomb)
          kinds answer @?= ["too-long"],
      testCase "a program that uses up its memory ends with a sentence" $ do
        worker <- borrow
        withRun worker "hungry" hungry (64 * megabytes) $ \link -> do
          _ <- hear worker
          firstStep link
          said <- linesUntil "settled" link
          gone <- hear worker
          let told = [text "kind" (field "problem" l) | l <- said ++ [gone], field "problem" l /= Null]
          assertBool (show (said, gone)) ("memory" `elem` told),
      testCase "a program that the kernel refuses more memory is blamed on the function at work" $ do
        worker <- borrow
        withRun worker "aborted" stuck (64 * megabytes) $ \link -> do
          _ <- hear worker
          firstStep link
          eventually "the child computes" (or <$> (childrenOf (processId worker) >>= mapM hasWorked))
          -- What the run-time system does when it is given no more.
          childrenOf (processId worker) >>= mapM_ (signalProcess sigABRT . fromIntegral)
          gone <- hear worker
          let told = field "problem" gone
          (text "firing" gone, text "kind" told, text "function" told, text "message" told) @?= ("forEver", "memory", "forEver", "forEver needed too much memory."),
      testCase "a program with empty places runs until it needs one, and says what is in scope there" $ do
        worker <- borrow
        answer <- ask worker (check (Number 1) unfinished)
        (kinds answer, severities answer) @?= (["hole", "hole"], ["warning", "warning"])
        withRun worker "unfinished" unfinished (64 * megabytes) $ \link -> do
          started <- hear worker
          text "op" started @?= "started"
          firstStep link
          said <- linesUntil "settled" link
          map (field "commands") (take 1 (reverse said)) @?= [toJSON ["Velocity 0.1 0.0" :: Text]]
          say link (object ["op" .= ("step" :: Text), "step" .= (5 :: Int), "time" .= (0.1 :: Double)])
          ending <- last <$> linesUntil "ended" link
          let told = field "problem" ending
          (text "kind" told, text "function" told, text "message" told, text "hint" told)
            @?= ("hole", "forward", "The run came to the empty place ‘_speed’ in ‘ahead’ (line 7).", "It needs a ‘Double’; you have ‘t :: Seconds’.")
          (field "start" told, field "end" told) @?= (position 7 20, position 7 26)
          hear worker >>= (@?= "gone") . text "op",
      testCase "a program without a controller comes to its empty place at once; a mistake beside an empty place is refused" $ do
        worker <- borrow
        forM_ ["main = simulate _\n", "main = simulate (_, _)\n", "main = simulate (\n  _, Velocity 0 0)\n"] $ \source ->
          withRun worker (String source) source (64 * megabytes) $ \link -> do
            started <- hear worker
            (source, text "op" started) @?= (source, "started")
            firstStep link
            ending <- last <$> linesUntil "ended" link
            (source, text "kind" (field "problem" ending), text "hint" (field "problem" ending)) @?= (source, "hole", "It needs a value.")
            _ <- hear worker
            pure ()
        withRun worker "wrong" "main = simulate (_, Velocity True 0)\n" (64 * megabytes) $ \_ -> do
          refused <- hear worker
          (text "op" refused, "type-mismatch" `elem` kinds refused) @?= ("refused", True),
      testCase "the worker's children hold no capability, whichever user started it" $ do
        worker <- borrow
        _ <- ask worker (check (Number 1) idle)
        withRun worker "capabilities" stuck (64 * megabytes) $ \_ -> do
          started <- hear worker
          text "op" started @?= "started"
          children <- allChildrenOf (processId worker)
          assertBool "a checker and a run" (length children >= 2)
          forM_ children $ \child -> forM_ ["CapInh", "CapPrm", "CapEff", "CapAmb"] $ \set -> do
            -- One that was just forked gives its capabilities up a moment later.
            eventually set ((\held -> not (null held) && all (all (== '0')) held) <$> threadStatus set child)
          _ <- ask worker (kill "capabilities")
          pure (),
      testCase "Safe Haskell alone refuses what is unsafe" $
        withWorker ["--without", "lists"] $ \worker -> do
          forM_ ["System.IO.Unsafe", "Unsafe.Coerce", "GHC.Exts", "GHC.IO", "Foreign.ForeignPtr.Unsafe", "Control.Monad.ST.Unsafe", "GHC.Conc", "GHC.Ptr"] $ \m -> do
            answer <- ask worker (check (Number 1) ("import " <> m <> "\nmain = pure ()\n"))
            (m, kinds answer) @?= (m, ["import"])
          forM_ ["System.IO", "Data.IORef", "Data.List", "Data.Map"] $ \m -> do
            answer <- ask worker (check (Number 1) ("import " <> m <> "\nmain = pure ()\n"))
            (m, kinds answer) @?= (m, [])
          forM_ ["{-# LANGUAGE TemplateHaskell #-}\nmain = $(undefined)", "{-# LANGUAGE Trustworthy #-}\nimport System.IO.Unsafe\nmain = pure ()"] $ \source -> do
            answer <- ask worker (check (Number 1) source)
            assertBool (show (source, answer)) (not (null (kinds answer))),
      testCase "what is on the list can be imported" $ do
        worker <- borrow
        forM_ ["Rosy", "Prelude", "Data.Coerce", "Data.Map", "System.Random", "GHC.Generics", "Text.Printf"] $ \m -> do
          answer <- ask worker (check (Number 1) ("import " <> m <> "\nmain = simulate (Velocity 0 0)\n"))
          (m, kinds answer) @?= (m, []),
      testCase "the same source again gets the same answer" $ do
        worker <- borrow
        first <- ask worker (check (Number 1) stuck)
        second <- ask worker (check (Number 1) stuck)
        first @?= second,
      testCase "nonsense on the socket is answered, and the next request served" $ do
        worker <- borrow
        tellBytes worker "this is not JSON\n"
        tellBytes worker (ByteString.replicate (5 * megabytes) 120 <> "\n")
        tellBytes worker "{\"op\":\"dance\",\"id\":7}\n[]\n\n{\"op\":\"check\"}\n"
        tellBytes worker "{\"op\":\"run\",\"id\":8,\"source\":\"main = pure ()\",\"memory\":1000000}\n"
        tell worker (kill "unknown")
        answers <- replicateM 6 (hear worker)
        map (text "op") answers @?= replicate 6 "failed"
        map (field "id") answers @?= [Null, Null, Number 7, Null, Null, Number 8]
        answer <- ask worker (check (Number 9) idle)
        (text "op" answer, kinds answer) @?= ("checked", []),
      testCase "when the service goes, the worker and its programs go" $ leavingNothing closeWorker,
      testCase "each run runs its own program" $ do
        worker <- borrow
        forM_ [1 .. 3 :: Int] $ \n -> do
          let source = "main = simulate (Say \"" <> Text.pack (show n) <> "\")\n"
          withRun worker (toJSON n) source (64 * megabytes) $ \link -> do
            _ <- answerOf worker (toJSON n)
            firstStep link
            said <- linesUntil "settled" link
            assertBool (show said) (toJSON ["Say \"" <> Text.pack (show n) <> "\""] `elem` map (field "commands") said)
          _ <- answerOf worker (toJSON n)
          pure (),
      testCase "a hundred checks in a row are all answered" $ do
        worker <- borrow
        replicateM_ 2 $ do
          forM_ [1 .. 50 :: Int] (\n -> tell worker (check (toJSON n) ("x = " <> Text.pack (show n))))
          answers <- replicateM 50 (hear worker)
          map kinds answers @?= replicate 50 ["no-main"],
      testCase "a forked worker ends, with its programs, when its socket is closed or its fork server dies" $
        withWorker [] $ \worker -> do
          one <- forked worker "one"
          two <- forked worker "two"
          withRun one "running" stuck (64 * megabytes) $ \_ -> do
            _ <- hear one
            program <- onlyChildOf (processId one)
            closeWorker one
            gone <- hear worker
            (text "op" gone, text "id" gone) @?= ("gone", "one")
            eventually "the program has ended" (not <$> isAlive program)
          signalProcess sigKILL (fromIntegral (processId worker))
          eventually "the other one has ended" (not <$> isAlive (processId two)),
      testCase "what takes too much memory to check is told so" $
        withWorker ["--check-memory", show (40 * megabytes), "--check-seconds", "60"] $ \worker -> do
          answer <- ask worker (check (Number 1) bulky)
          kinds answer @?= ["too-large"],
      testCase "a program that has computed for too long ends with a sentence" $
        withWorker ["--run-seconds", "1"] $ \worker ->
          withRun worker "busy" stuck (64 * megabytes) $ \link -> do
            _ <- hear worker
            firstStep link
            gone <- hear worker
            (text "op" gone, text "kind" (field "problem" gone), text "firing" gone) @?= ("gone", "time", "forEver"),
      testCase "eight programs that need too much memory to compile stay below one ceiling" $
        withWorker ["--check-memory", show (48 * megabytes), "--total-memory", show (80 * megabytes), "--check-seconds", "600"] $ \worker -> do
          own <- anonymousMemory (processId worker)
          links <- forM [1 .. 8 :: Int] (\n -> run worker (toJSON n) (bulky <> "\n-- " <> Text.pack (show n)) (64 * megabytes))
          peak <- newIORef 0
          watcher <- forkIO . forever $ do
            children <- allChildrenOf (processId worker)
            sizes <- mapM (fmap (\size -> max 0 (size - own)) . anonymousMemory) children
            modifyIORef' peak (max (sum sizes))
            -- A compilation allocates some 3 MB in this time. Looking all the time would take a processor from the compilations.
            threadDelay 10000
          answers <- replicateM 8 (hear worker)
          killThread watcher
          assertEqual (show answers) (replicate 8 "refused") (map (text "op") answers)
          map kinds answers @?= replicate 8 ["too-large"]
          -- Two compilations at once, each with its own limit, and what is allocated between two looks.
          most <- readIORef peak
          assertBool (show (most `div` megabytes) <> " MB") (most < 140 * megabytes)
          mapM_ closeLink links,
      testCase "a run that waits to be compiled can be ended" $
        withWorker ["--check-seconds", "60"] $ \worker -> do
          links <- forM ["a", "b", "c" :: Text] (\n -> run worker (toJSON n) (bomb <> "\n-- " <> n) (64 * megabytes))
          answer <- ask worker (kill "c")
          (text "id" answer, text "op" answer, field "signal" answer) @?= ("c", "gone", Number 9)
          forM_ ["a", "b"] (tell worker . kill)
          others <- replicateM 2 (hear worker)
          sort (map (text "id") others) @?= ["a", "b"]
          mapM_ closeLink links,
      testCase "when the worker is killed, its programs go" $ leavingNothing (signalProcess sigKILL . fromIntegral . processId)
    ]
  where
    kinds = ofProblems "kind"
    severities = ofProblems "severity"
    ofProblems key answer = case field "problems" answer of
      Array ps -> [text key p | p <- foldr (:) [] ps]
      _ -> []
    position l c = object ["line" .= (l :: Int), "column" .= (c :: Int)]
    -- Whatever ends the worker ends what runs in it.
    leavingNothing end' = withWorker [] $ \worker -> do
      link <- run worker "r" stuck (64 * megabytes)
      _ <- hear worker
      children <- childrenOf (processId worker)
      assertBool "there is a program" (not (null children))
      () <- end' worker
      ended worker
      forM_ children (\c -> eventually "the program is gone" (not <$> isAlive c))
      closeLink link
    -- The program is there, and has been told what it needs for its first firing.
    firstStep link = do
      say link start
      _ <- linesUntil "ready" link
      say link odometry
      say link (object ["op" .= ("step" :: Text), "step" .= (0 :: Int), "time" .= (0 :: Double)])
    -- Has computed for a quarter of a second: starting takes a tenth of that. (proc(5): utime is field 14, in hundredths.)
    hasWorked pid = do
      -- Another, from the test before, may be gone by now.
      stat <- fromRight "" <$> (try (readFile ("/proc/" ++ show pid ++ "/stat") >>= \s -> s <$ evaluate (length s)) :: IO (Either IOException String))
      pure (case drop 12 (words (dropWhile (/= ')') stat)) of (utime : _) -> (read utime :: Int) > 25; [] -> False)

-- | The first line of a link.
start :: Value
start = object ["op" .= ("start" :: Text), "protocol" .= (1 :: Int), "seed" .= (1 :: Int), "trace" .= True]

-- | The robot stands at the origin.
odometry :: Value
odometry =
  object
    [ "op" .= ("publish" :: Text),
      "topic" .= ("/odom" :: Text),
      "msg"
        .= object
          [ "pose" .= object ["pose" .= object ["position" .= object ["x" .= zero, "y" .= zero], "orientation" .= object ["z" .= zero, "w" .= (1 :: Double)]]],
            "twist" .= object ["twist" .= object ["linear" .= object ["x" .= zero], "angular" .= object ["z" .= zero]]]
          ]
    ]
  where
    zero = 0 :: Double

-- | Ends at once.
idle :: Text
idle = "main = pure ()\n"

-- | Never settles once it has been given a velocity.
stuck :: Text
stuck = Text.unlines ["main = simulate forEver", "", "forEver :: Velocity -> Velocity", "forEver (Velocity v w) = Velocity (count (v + 1)) w", "  where count x = if x > 0 then count (x + 1) else x"]

-- | Needs its first empty place after a tenth of a second, and the other never.
unfinished :: Text
unfinished = Text.unlines ["main = simulate (forward, back)", "", "forward :: Seconds -> Velocity", "forward t = if t < 0.1 then Velocity 0.1 0 else ahead t", "", "ahead :: Seconds -> Velocity", "ahead t = Velocity _speed 0", "", "back :: Bumper -> Velocity", "back _ = Velocity _ 0"]

-- | Takes more and more memory once it has been given a velocity.
hungry :: Text
hungry = Text.unlines ["main = simulate eat", "", "eat :: Velocity -> Velocity", "eat (Velocity v w) = Velocity (fromIntegral (length xs) + fromIntegral (last xs) + v) w", "  where xs = [1 .. 100000000 :: Int]"]

-- | Needs some 100 MB to be checked, which grow with the list: on a machine of any speed the memory ends before the time.
bulky :: Text
bulky = "main = print (length [" <> Text.intercalate "," (replicate 20000 "(0,'x')") <> "])\n"

-- | Its types double with every line: no machine has the time to check it. It may need little memory.
bomb :: Text
bomb = Text.unlines (["main = print (length (show (f30 'x')))", "f0 x = (x, x)"] ++ ["f" <> n k <> " x = f" <> n (k - 1) <> " (f" <> n (k - 1) <> " x)" | k <- [1 .. 30 :: Int]])
  where
    n = Text.pack . show
