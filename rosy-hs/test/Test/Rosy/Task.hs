{-# LANGUAGE DeriveGeneric #-}

-- |
-- Module      : Test.Rosy.Task
-- Description : Rule R10 as stories: one thing after another, beside each other, on call.
module Test.Rosy.Task (tests) where

import GHC.Generics (Generic)
import Rosy
import Rosy.Loop (What)
import Rosy.Program
import Rosy.Robot
import Rosy.Runnable (program)
import Support.Rehearsal (Cue (..), rehearse)
import qualified Support.Rehearsal as Rehearsal
import Support.Story
import Test.Tasty (TestTree, testGroup)
import Test.Tasty.HUnit

newtype Ping = Ping Int deriving (Show, Generic)

instance Value Ping

instance Sensor Ping

instance Command Ping

bump, push :: What
bump = sensed (BumperMessage (Bumper LeftBumper Pressed))
push = sensed (ButtonMessage (Button Button0 Pressed))

-- | Ends at the next bump.
untilBump :: Bumper -> Done ()
untilBump _ = Done ()

-- | Ends at the next button.
untilPush :: Button -> Done ()
untilPush _ = Done ()

tests :: TestTree
tests =
  testGroup
    "Task"
    [ testGroup "one after another" sequences,
      testGroup "values and types" values,
      testGroup "waiting, saying" small,
      testGroup "beside each other" together,
      testGroup "among functions" amongFunctions,
      testGroup "stopped" stopping,
      testGroup "called" calls
    ]

sequences :: [TestTree]
sequences =
  [ testCase "init once, then the controller, then the end of the program" $
      map (\h -> (heardCommands h, heardEnd h)) (hear (task (Led1 Green) (Velocity 0.5 0, untilBump)) [at 0 ticked, at 0.1 ticked, at 0.15 bump])
        @?= [(["Led1 Green"], Nothing), (["Velocity 0.5 0.0"], Nothing), (["Velocity 0.5 0.0"], Nothing), ([], Just "Finished")],
    testCase "init waits for its inputs: an event" $
      told (task (\(Button n _) -> Say (show n)) untilBump >> say "next") [at 0 bump, at 0.1 push, at 0.2 bump]
        @?= [(0.1, "Say \"Button0\""), (0.2, "Say \"next\"")],
    testCase "init waits for its inputs: a state, and then reads it" $
      told (task (\(Velocity v _) -> Say (show v)) untilBump) [at 0 bump, at 0.02 (moving 0.3)] @?= [(0.02, "Say \"0.3\"")],
    testCase "init reads a state at once when it has arrived" $
      told (wait 0.1 >> task (\(Velocity v _) -> Say (show v)) untilBump) [at 0 (moving 0.3), at 0.1 ticked] @?= [(0.1, "Say \"0.3\"")],
    testCase "the functions of a task are gone before the next one fires" $
      commandsOf (task () (untilBump, \(Bumper _ _) -> Say "too late")) [at 0 bump] @?= [],
    testCase "functions before the one that ends still have their turn" $
      commandsOf (task () (\(Bumper _ _) -> Say "in time", untilBump)) [at 0 bump] @?= ["Say \"in time\""],
    testCase "all of the firing that ends is carried out" $
      commandsOf (task () (\(Bumper _ _) -> (Done (), Led1 Red))) [at 0 bump] @?= ["Led1 Red"],
    testCase "a bump between two tasks is not seen by the second" $
      told (task () untilBump >> task () untilBump >> say "end") [at 0 bump, at 0.1 push, at 0.2 bump] @?= [(0.2, "Say \"end\"")],
    testCase "an event that the first task emitted is not for the second" $
      commandsOf (task () (\(Bumper _ _) -> (Ping 1, Done ())) >> task () (\(Ping n) -> Say (show n), untilPush)) [at 0 bump, at 0.1 bump] @?= [],
    testCase "an event that init emits starts the controller" $
      commandsOf (task (Ping 1) (\(Ping n) -> (Say (show n), Done ()))) [at 0 still] @?= ["Say \"1\""],
    testCase "memory is new in each task" $
      commandsOf (replicateM_ 2 (task () count)) [at (0.1 * k) bump | k <- [0 .. 3]] @?= ["Say \"0\"", "Say \"1\"", "Say \"0\"", "Say \"1\""],
    testCase "a param is the program's" $
      commandsOf (replicateM_ 2 (task () (\(Bumper _ _) (Param n) -> (Param (n + 1 :: Int), Say (show n), Done ())))) [at 0 bump, at 0.1 bump]
        @?= ["Say \"0\"", "Say \"1\""],
    testCase "tasks repeat, choose, recurse" $
      commandsOf (countdown 3) [at (0.1 * k) bump | k <- [0 .. 5]] @?= ["Say \"3\"", "Say \"2\"", "Say \"1\"", "Say \"off\""],
    testCase "forever goes on" $
      length (commandsOf (forever (task (Led1 Red) untilBump)) [at (0.1 * k) bump | k <- [1 .. 50]]) @?= 51
  ]
  where
    count (Bumper _ _) (Memory n) = (Memory (n + 1 :: Int), Say (show n), if n == 1 then Just (Done ()) else Nothing)
    countdown :: Int -> Task ()
    countdown 0 = say "off"
    countdown n = do
      task (Say (show n)) untilBump
      countdown (n - 1)

values :: [TestTree]
values =
  [ testCase "a task hands its value on" $
      commandsOf (task () (\(Button n _) -> Done n) >>= say . show) [at 0 push] @?= ["Say \"Button0\""],
    testCase "the first Done counts" $
      commandsOf (task () (\(Button _ _) -> [Done 1, Done (2 :: Int)]) >>= say . show) [at 0 push] @?= ["Say \"1\""],
    testCase "a Done that is chosen by the input" $
      commandsOf (task () (\(Bumper s _) -> if s == LeftBumper then Just (Done "left") else Nothing) >>= say) [at 0 bump] @?= ["Say \"left\""],
    testCase "a Done that escapes the types ends the program with both types" $
      heardEnd (last (hear (hidden (\(Bumper _ _) -> Done 'x')) [at 0 bump])) @?= Just "EndedWrongly \"function 1\" \"Char\" \"()\"",
    testCase "mapping over a task maps its value" $
      commandsOf (parallel (show <$> task () (\(Button _ _) -> Done (2 :: Int))) (pure ()) >>= say . fst) [at 0 push] @?= ["Say \"2\""]
  ]
  where
    -- The type of the controller is not known here, so only the run can tell.
    hidden :: Controller c => c -> Task ()
    hidden = task ()

small :: [TestTree]
small =
  [ testCase "once does it once and goes on" $
      told (once (Led1 Red) >> once (\(Bumper _ _) -> Led2 Red) >> say "end") [at 0.1 bump, at 0.2 bump]
        @?= [(0, "Led1 Red"), (0.1, "Led2 Red"), (0.1, "Say \"end\"")],
    testCase "wait lets time pass" $
      told (say "a" >> wait 0.1 >> say "b" >> wait 0.1 >> say "c") [at (0.02 * k) still | k <- [0 .. 20]]
        @?= [(0, "Say \"a\""), (0.1, "Say \"b\""), (0.2, "Say \"c\"")],
    testCase "a loop without waiting takes 64 steps an instant, and the world goes on" $ do
      let story = hear (forever (say "x")) [at 0 still, at 0.02 still]
      map (length . heardCommands) story @?= [64, 64, 64]
  ]

amongFunctions :: [TestTree]
amongFunctions =
  [ testCase "a task in a tuple runs beside the functions" $
      told (\(Bumper _ _) -> Say "bump", say "a" >> wait 0.1 >> say "b") [at 0 bump, at 0.1 bump, at 0.2 bump]
        @?= [(0, "Say \"a\""), (0, "Say \"bump\""), (0.1, "Say \"bump\""), (0.1, "Say \"b\""), (0.2, "Say \"bump\"")],
    testCase "the program goes on when it has ended" $
      map heardEnd (hear (Led1 Red, wait 0.1) [at (0.1 * k) ticked | k <- [0 .. 3]]) @?= replicate 5 Nothing,
    testCase "it has a memory of its own" $
      commandsOf (countBumps "outside", task () (countBumps "inside" :: Bumper -> Memory Int -> (Memory Int, Say)) :: Task ()) [at 0 bump, at 0.1 bump]
        @?= ["Say \"outside 0\"", "Say \"inside 0\"", "Say \"outside 1\"", "Say \"inside 1\""],
    testCase "it is stopped with the task around it" $
      commandsOf (task () (untilBump, taskWith taskOptions {stopped = Led1 Red} (\Never -> Done ())) >> say "end") [at 0 still, at 0.1 bump]
        @?= ["Led1 Red", "Say \"end\""],
    testCase "its result is ignored" $
      commandsOf (wait 0.1 >> pure 'x', say "b") [at 0 still, at 0.1 still] @?= ["Say \"b\""]
  ]
  where
    countBumps :: String -> Bumper -> Memory Int -> (Memory Int, Say)
    countBumps who _ (Memory n) = (Memory (n + 1), Say (who ++ " " ++ show n))

together :: [TestTree]
together =
  [ testCase "parallel waits for both, also when both give the same type" $
      map (\h -> (heardAt h, heardEnd h)) (hear (parallel (wait 1) (wait 3)) [at (0.5 * k) ticked | k <- [0 .. 8]])
        @?= [(0, Nothing)] ++ [(0.5 * k, Nothing) | k <- [0 .. 5]] ++ [(3, Just "Finished")],
    testCase "parallel gives both values, each from its place" $
      commandsOf (parallel (task () (\(Button _ _) -> Done 1)) (task () (\(Bumper _ _) -> Done (2 :: Int))) >>= \r -> say (show (r :: (Int, Int)))) [at 0 bump, at 0.1 push]
        @?= ["Say \"(1,2)\""],
    testCase "the loser of a race stands" $
      told (race (task (Velocity 0.3 0) untilPush) (wait 0.1) >> wait 0.1) [at (0.1 * k) ticked | k <- [0 .. 1]]
        @?= [(0, "Velocity 0.3 0.0"), (0.1, "Velocity 0.0 0.0")],
    testCase "the loser of a race does not stop what another function drives" $
      told (\() -> Velocity 0.2 0, race (task (Velocity 0.3 0) untilPush) (wait 0.1)) [at (0.1 * k) ticked | k <- [0 .. 1]]
        @?= [(0, "Velocity 0.3 0.0"), (0, "Velocity 0.2 0.0"), (0.1, "Velocity 0.2 0.0")],
    testCase "race ends with the first, told by its place" $
      commandsOf (race (wait 3 >> pure 'a') (wait 1 >> pure 'b') >>= say . show) [at (0.5 * k) ticked | k <- [0 .. 8]] @?= ["Say \"Right 'b'\""],
    testCase "when both end at once the left one wins" $
      commandsOf (race (task () untilBump) (task () untilBump) >>= say . show) [at 0 bump] @?= ["Say \"Left ()\""],
    testCase "the loser of a race drives no more" $
      told (race (task () (Velocity 0.5 0) :: Task ()) (task () untilBump) >> wait 0.2) [at 0 ticked, at 0.1 ticked, at 0.15 bump, at 0.2 ticked, at 0.3 ticked]
        @?= [(0, "Velocity 0.5 0.0"), (0.1, "Velocity 0.5 0.0"), (0.15, "Velocity 0.0 0.0")],
    testCase "side by side, each has its own memory" $
      commandsOf (parallel count count) [at 0 bump, at 0.1 bump] @?= ["Say \"0\"", "Say \"0\"", "Say \"1\"", "Say \"1\""]
  ]
  where
    count :: Task ()
    count = task () (\(Bumper _ _) (Memory n) -> (Memory (n + 1 :: Int), Say (show n)))

stopping :: [TestTree]
stopping =
  [ testCase "the loser of a race cleans up once, before anything else" $
      commandsOf (race guarded (task () untilBump) >> say "won") [at 0 ticked, at 0.1 bump] @?= ["Velocity 0.5 0.0", "Led1 Red", "Velocity 0.0 0.0", "Say \"won\""],
    testCase "a task that ends by itself is not stopped" $
      commandsOf (taskWith taskOptions {stopped = Led1 Red} untilBump) [at 0 bump] @?= [],
    testCase "an error in one function stops every live task" $ do
      let story = hear (parallel guarded broken) [at 0 bump]
      concatMap heardCommands story @?= ["Led1 Red"]
      heardEnd (last story) @?= Just "Failed",
    testCase "an error in a clean-up does not keep the others from theirs" $ do
      let bad = taskWith taskOptions {stopped = errorWithoutStackTrace "again" :: Say} (\Never -> Done ())
      concatMap heardCommands (hear (parallel (parallel guarded bad) broken) [at 0 bump])
        @?= ["Led1 Red"],
    testCase "clean-up reads the memory of its task" $
      commandsOf (race (taskWith TaskOptions {starting = Memory (7 :: Int), stopped = \(Memory n) -> Say (show (n :: Int))} (\Never -> Done ())) (task () untilBump)) [at 0 bump]
        @?= ["Say \"7\""]
  ]
  where
    guarded, broken :: Task ()
    guarded = taskWith taskOptions {stopped = Led1 Red} (Velocity 0.5 0)
    broken = task () (\(Bumper _ _) -> errorWithoutStackTrace "oh" :: Led2)

calls :: [TestTree]
calls =
  [ testCase "a called task runs beside its caller" $
      commandsOf (\(Button _ _) -> call (once (Led1 Red) >> task () (\(Bumper _ _) -> (Led2 Red, Done ()))) quiet) [at 0 push, at 0.1 bump, at 0.2 bump]
        @?= ["Led1 Red", "Led2 Red"],
    testCase "once does not stay to hear of what it calls, so calling there is an error" $ do
      let heard = hear (parallel guarded (once (\(Bumper _ _) -> (Led1 Orange, call (once (Led2 Red)) quiet)) >> say "next")) [at 0 bump]
      concatMap heardCommands heard @?= ["Led1 Orange", "Led1 Red"]
      heardEnd (last heard) @?= Just "CalledInOnce \"once\"",
    testCase "its end is answered" $
      commandsOf (\(Button _ _) -> call (task () (\(Bumper s _) -> Done s)) callOptions {onEnd = Say . show}) [at 0 push, at 0.1 bump]
        @?= ["Say \"LeftBumper\""],
    testCase "its feedback is answered, each in order" $
      commandsOf (\(Button _ _) -> call (task () (\(Bumper s _) -> Feedback s) :: Task ()) callOptions {onFeedback = \s -> Say (show (s :: BumperSide))}) [at 0 push, at 0.1 bump, at 0.2 bump]
        @?= ["Say \"LeftBumper\"", "Say \"LeftBumper\""],
    testCase "several feedbacks of one firing are answered in their order" $
      commandsOf (\(Button _ _) -> call (task () (\(Bumper _ _) -> (Feedback 'a', Feedback 'b')) :: Task ()) spoken) [at 0 push, at 0.1 bump]
        @?= ["Say \"a\"", "Say \"b\""],
    testCase "feedback that the caller does not answer is for its own caller" $
      commandsOf (\(Button _ _) -> call (task () (\(Bumper _ _) -> call reporter quiet) :: Task ()) spoken) [at 0 push, at 0.1 bump, at 0.2 (moving 0.3)]
        @?= ["Say \"x\""],
    testCase "a cancelled sequence stops in whatever step it is, and cleans up once" $
      commandsOf (\(Button n _) -> if n == Button0 then Just (call twoSteps quiet {cancelOn = \(ButtonOne _) -> Just Cancel}) else Nothing) story
        @?= ["Say \"one\"", "Say \"two\"", "Velocity 0.5 0.0", "Led1 Red", "Velocity 0.0 0.0"],
    testCase "what a called task remembers is forgotten at its end" $
      map heardMemory (hear (\(Button _ _) -> call (task () (\(Bumper _ _) (Memory n) -> (Memory (n + 1 :: Int), if n == 1 then Just (Done ()) else Nothing))) quiet) [at 0 push, at 0.1 bump, at 0.2 bump])
        @?= [[], [], [("Memory Int", "1")], []],
    testCase "a state that cancels a call wakes a program that waits for nothing else" $ do
      let whenFast (Velocity v _) = if v > 0.2 then Just Cancel else Nothing
          asleep = taskWith taskOptions {stopped = Led1 Red} (\Never -> Done ()) :: Task ()
          driving v = OdometryMessage (Odometry (Position 0 0) (Orientation 0) (Velocity v 0))
          cues = [Steps 0 [BumperMessage (Bumper LeftBumper Pressed)] True, Steps 1 [driving 0.1] False, Steps 2 [driving 0.3] False]
      heard <- rehearse cues (program (Names []) (\(Bumper _ _) -> call asleep quiet {cancelOn = whenFast}))
      [(Rehearsal.heardAt h, c) | h <- heard, c <- Rehearsal.heardCommands h] @?= [(2, "Led1 Red")],
    testCase "two calls at once are two tasks" $
      commandsOf (\(Button _ _) -> call (wait 0.1 >> say "done") quiet) [at 0 push, at 0.05 push, at 0.1 ticked, at 0.15 ticked, at 0.2 ticked]
        @?= ["Say \"done\"", "Say \"done\""],
    testCase "the end of the caller stops what it called, before the next task" $
      commandsOf (task () (\(Button _ _) -> call guarded quiet, untilBump) >> say "next") [at 0 push, at 0.1 ticked, at 0.2 bump, at 0.3 ticked]
        @?= ["Velocity 0.5 0.0", "Led1 Red", "Velocity 0.0 0.0", "Say \"next\""],
    testCase "a Done in the answer ends the caller" $
      commandsOf (task () (\(Button _ _) -> call (wait 0.1 >> pure 'x') callOptions {onEnd = Done}) >>= \c -> say [c]) [at 0 push, at 0.1 ticked]
        @?= ["Say \"x\""]
  ]
  where
    quiet :: CallOptions Never () () end ()
    quiet = callOptions
    spoken = callOptions {onFeedback = \c -> Say [c :: Char]}
    reporter = task () (\(Velocity _ _) -> (Feedback 'x', Done ())) :: Task ()
    guarded :: Task ()
    guarded = taskWith taskOptions {stopped = Led1 Red} (Velocity 0.5 0)
    twoSteps = say "one" >> task () untilBump >> say "two" >> guarded
    story = [at 0 push, at 0.1 bump, at 0.2 ticked, at 0.3 (sensed (ButtonMessage (Button Button1 Pressed))), at 0.4 ticked, at 0.5 ticked]
