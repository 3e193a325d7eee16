{-# LANGUAGE DeriveGeneric #-}

-- |
-- Module      : Test.Rosy.Controller
-- Description : The shapes of rules R14 to R17 and the execution rules R1 to R9, as stories.
module Test.Rosy.Controller (tests) where

import GHC.Generics (Generic)
import Rosy
import Rosy.Loop (What)
import Rosy.Program
import Rosy.Robot
import Support.Story
import Test.Tasty (TestTree, testGroup)
import Test.Tasty.HUnit

-- | Events of the program's own, with the instances that the worker gives.
newtype Ping = Ping Int deriving (Show, Generic)

instance Value Ping

instance Default Ping

instance Sensor Ping

instance Command Ping

data Pair a = Pair a a deriving (Show, Generic)

instance Value a => Value (Pair a)

instance Value a => Default (Pair a)

instance Value a => Sensor (Pair a)

instance Value a => Command (Pair a)

bump, unbump, push, hole :: What
bump = sensed (BumperMessage (Bumper LeftBumper Pressed))
unbump = sensed (BumperMessage (Bumper LeftBumper Released))
push = sensed (ButtonMessage (Button Button0 Pressed))
hole = sensed (CliffMessage (Cliff CenterCliff Hole))

tests :: TestTree
tests =
  testGroup
    "Controller"
    [ testGroup "rule R1: events trigger" events,
      testGroup "rule R2: states trigger when there is no event" states,
      testGroup "rule R3: samples never trigger" samples,
      testGroup "rule R4: Either, as it comes" eithers,
      testGroup "rule R5: a state that has not arrived is waited for" waiting,
      testGroup "rule R6: firing is one transaction" transactions,
      testGroup "rule R7: memory" memories,
      testGroup "rule R8: user events" users,
      testGroup "rule R9 and outputs" outputs,
      testGroup "rule R25: priority" priorities,
      testGroup "controllers and names" controllers
    ]

priorities :: [TestTree]
priorities =
  [ says
      "the first keeps the actuator for its time; then the latest command of the second holds again"
      (priority 1 back drive')
      [at 0 ticked, at 0.1 bump, at 0.2 ticked, at 1.0 ticked, at 1.1 still, at 1.2 still]
      [(0, forwards), (0.1, backwards), (1.1, forwards)],
    says
      "each command of the first begins the time anew"
      (priority 1 back drive')
      [at 0 ticked, at 0.5 bump, at 1.0 bump, at 1.6 ticked, at 2.0 ticked]
      [(0, forwards), (0.5, backwards), (1.0, backwards), (2.0, forwards), (2.0, forwards)],
    says
      "without a time it goes before only in its instant"
      (priority 0 always' drive')
      [at 0 ticked, at 0.1 ticked]
      [(0, backwards), (0.1, forwards), (0.1, backwards)],
    says
      "the first may stand still: it does not command"
      (priority 1 back drive')
      [at 0 ticked, at 0.1 unbump, at 0.2 ticked]
      [(0, forwards), (0.2, forwards)],
    says
      "other actuators are not held, and lines are no actuator"
      (priority 1 back (lamp, line))
      [at 0.1 bump, at 0.2 ticked]
      [(0.1, backwards), (0.2, "Led1 Red"), (0.2, "Say \"here\"")],
    says
      "a sound is held back, and not played later"
      (priority 1 (\b -> [ErrorSound | b == Bumper LeftBumper Pressed]) OnSound)
      [at 0 ticked, at 0.1 bump, at 0.2 ticked, at 1.15 still, at 1.2 ticked]
      [(0, "OnSound"), (0.1, "ErrorSound"), (1.2, "OnSound")],
    says
      "the inner one decides first, and what it lets pass is of its side of the outer one"
      (priority 1 (priority 0.5 back start) drive')
      [at 0 ticked, at 0.1 bump, at 0.2 push, at 0.6 still, at 1.5 ticked, at 1.6 still]
      [(0, forwards), (0.1, backwards), (0.6, "Velocity 0.0 1.0"), (1.6, forwards)],
    says
      "a task on the second side goes on, and its command holds again"
      (priority 1 back (once (Velocity 0.2 0) >> wait 9))
      [at 0 still, at 0.5 bump, at 1.4 still, at 1.5 still]
      [(0, forwards), (0.5, backwards), (1.5, forwards)],
    says
      "a task on the first side keeps the actuator too, with a priority of its own inside"
      (priority 1 (wait 0.5 >> (task () (priority 0 back (Velocity 0 0)) :: Task ())) drive')
      [at 0 ticked, at 0.4 ticked, at 0.5 still, at 0.6 ticked, at 0.7 bump, at 0.8 still, at 1.65 still, at 1.7 ticked]
      [(0, forwards), (0.4, forwards), (0.6, forwards), (0.6, "Velocity 0.0 0.0"), (0.7, backwards), (0.8, "Velocity 0.0 0.0"), (1.7, "Velocity 0.0 0.0")],
    testCase "the controllers keep their names" $
      firedIn (Names [Name "back", Name "drive"]) (priority 1 back drive') [at 0 ticked, at 0.1 bump] @?= ["drive", "back"]
  ]
  where
    says title controller story expected = testCase title (told controller story @?= expected)
    forwards = "Velocity 0.2 0.0"
    backwards = "Velocity (-0.2) 0.0"
    drive' = Velocity 0.2 0
    always' = Velocity (-0.2) 0
    back b = if b == Bumper LeftBumper Pressed then Just (Velocity (-0.2) 0) else Nothing
    start (Button _ _) = Velocity 0 1
    lamp = Led1 Red
    line = Say "here"

events :: [TestTree]
events =
  [ testCase "a function of an event fires at each, and at nothing else" $
      told (\b -> Say (show (b :: Bumper))) [at 0.1 bump, at 0.2 push, at 0.3 still, at 0.4 ticked, at 0.5 unbump]
        @?= [(0.1, "Say \"Bumper LeftBumper Pressed\""), (0.5, "Say \"Bumper LeftBumper Released\"")],
    testCase "ten bumps 15 ms apart are ten firings" $
      length (commandsOf bumpSound [at (0.015 * k) bump | k <- [1 .. 10]]) @?= 10,
    testCase "an event reads the newest state, and does not wait for a fresh one" $
      commandsOf (\b (Velocity v _) -> Say (show (v, b == Bumper LeftBumper Pressed))) [at 0 (moving 0.2), at 0.1 bump, at 0.2 bump]
        @?= ["Say \"(0.2,True)\"", "Say \"(0.2,True)\""],
    testCase "two events are joined when both are there, the newest of each" $
      commandsOf (\b c -> Say (show (b :: Bumper, c :: Cliff))) [at 0.1 bump, at 0.2 unbump, at 0.3 hole, at 0.4 hole, at 0.5 bump]
        @?= ["Say \"(Bumper LeftBumper Released,Cliff CenterCliff Hole)\"", "Say \"(Bumper LeftBumper Pressed,Cliff CenterCliff Hole)\""],
    testCase "a tuple is all of these, as curried arguments are" $
      commandsOf (\(b, s) -> Say (show (b :: Bumper, s :: Seconds))) [at 0.1 bump, at 0.2 still]
        @?= ["Say \"(Bumper LeftBumper Pressed,Seconds 0.1)\""],
    testCase "nine inputs are possible, in one tuple" $
      commandsOf
        nine
        [at 0 still, at 0.1 bump]
        @?= ["Say \"nine\""],
    testCase "one-sided views hear their side only" $
      commandsOf (\(BumperRight s) -> Say (show s)) [at 0.1 bump, at 0.2 (sensed (BumperMessage (Bumper RightBumper Released)))]
        @?= ["Say \"Released\""],
    testCase "each of the eleven hears its own" $
      commandsOf
        ( (\(BumperLeft _) -> heardAs "LeftBumper", \(BumperCenter _) -> heardAs "CenterBumper", \(BumperRight _) -> heardAs "RightBumper"),
          (\(CliffLeft _) -> heardAs "LeftCliff", \(CliffCenter _) -> heardAs "CenterCliff", \(CliffRight _) -> heardAs "RightCliff"),
          (\(WheelLeft _) -> heardAs "LeftWheel", \(WheelRight _) -> heardAs "RightWheel"),
          (\(ButtonZero _) -> heardAs "Button0", \(ButtonOne _) -> heardAs "Button1", \(ButtonTwo _) -> heardAs "Button2")
        )
        ( [at 0.1 (sensed (BumperMessage (Bumper side Pressed))) | side <- [minBound ..]]
            ++ [at 0.1 (sensed (CliffMessage (Cliff side Hole))) | side <- [minBound ..]]
            ++ [at 0.1 (sensed (WheelMessage (Wheel side Air))) | side <- [minBound ..]]
            ++ [at 0.1 (sensed (ButtonMessage (Button number Pressed))) | number <- [minBound ..]]
        )
        @?= map
          (\side -> "Say " ++ show side)
          (map show [LeftBumper ..] ++ map show [LeftCliff ..] ++ map show [LeftWheel ..] ++ map show [Button0 ..]),
    testCase "the robot's going on line and off is an event" $
      commandsOf (\s -> Say (show (s :: RobotStatus))) [at 0.1 (sensed (RobotStatusMessage s)) | s <- [Online, Offline]] @?= ["Say \"Online\"", "Say \"Offline\""],
    testCase "() is the tick, and an event" $
      told (\() (Velocity v _) -> Say (show v)) [at 0 ticked, at 0.02 (moving 1), at 0.04 (moving 2), at 0.1 ticked]
        @?= [(0.02, "Say \"1.0\""), (0.1, "Say \"2.0\"")],
    testCase "Never never happens" $
      commandsOf (\Never -> Say "no") [at 0 bump, at 0.1 still, at 0.2 ticked] @?= []
  ]

nine :: (Bumper, Velocity, Position, Orientation, Pose, Seconds, Clock, Memory Int, Param Int) -> Say
nine (Bumper _ _, Velocity _ _, Position _ _, _, Pose _ _, _, Clock {}, Memory _, Param _) = Say "nine"

bumpSound :: Bumper -> Maybe Sound
bumpSound (Bumper _ Pressed) = Just ErrorSound
bumpSound _ = Nothing

heardAs :: String -> Say
heardAs = Say

states :: [TestTree]
states =
  [ testCase "once per odometry message, however many states it takes" $
      told (\(Velocity v _) (Position x _) (Pose _ o) -> Say (show (v, x, o))) [at 0 still, at 0.01 ticked, at 0.02 (moving 1), at 0.03 bump]
        @?= [(0, "Say \"(0.0,0.0,Orientation 0.0)\""), (0.02, "Say \"(1.0,0.0,Orientation 0.0)\"")],
    testCase "with samples beside them as well" $
      map fst (told (\s (Velocity _ _) -> Say (show (s :: Seconds))) [at 0 ticked, at 0.02 still, at 0.04 still]) @?= [0.02, 0.04]
  ]

samples :: [TestTree]
samples =
  [ testCase "a value goes out at the default rate" $
      told (Velocity 0.5 0) [at 0 still, at 0 ticked, at 0.02 still, at 0.1 ticked]
        @?= [(0, "Velocity 0.5 0.0"), (0.1, "Velocity 0.5 0.0")],
    testCase "a function of samples fires at the default rate" $
      told (\s -> Say (show (s :: Seconds))) [at 0 still, at 0 ticked, at 0.1 ticked]
        @?= [(0, "Say \"Seconds 0.0\""), (0.1, "Say \"Seconds 0.1\"")],
    testCase "a clock counts from the start of the program" $
      commandsOf (\c -> Say (show (c :: Clock))) [at 3723.04 ticked] @?= ["Say \"Clock 1 2 3 40\""],
    testCase "a generator is fresh each time it is read, also twice in one function" $ do
      let numbers = commandsOf (\g h -> Say (show (fst (random (g :: StdGen)) :: Int, fst (random (h :: StdGen)) :: Int))) [at 0 ticked, at 0.1 ticked]
      length numbers @?= 2
      assertBool "fresh" (head numbers /= last numbers)
      assertBool "different" (all (\line -> let (a, b) = read (read (drop 4 line)) :: (Int, Int) in a /= b) numbers)
  ]

eithers :: [TestTree]
eithers =
  [ testCase "a new value whenever one side has" $
      commandsOf (Say . either (\(Bumper _ s) -> show s) (\(Cliff _ s) -> show s)) [at 0.1 bump, at 0.2 hole]
        @?= ["Say \"Pressed\"", "Say \"Hole\""],
    testCase "a state inside an Either triggers like an event" $
      commandsOf (Say . either (\(Bumper _ s) -> show s) (\(Velocity v _) -> show v)) [at 0.1 bump, at 0.2 (moving 3)]
        @?= ["Say \"Pressed\"", "Say \"3.0\""],
    testCase "a message that both sides take arrives on both, left first" $
      commandsOf (Say . either (\(BumperLeft s) -> "left " ++ show s) (\(Bumper _ s) -> "any " ++ show s)) [at 0.1 bump]
        @?= ["Say \"left Pressed\"", "Say \"any Pressed\""],
    testCase "Maybe is with it, or at the default rate without it" $
      commandsOf (\m -> Say (show (m :: Maybe Bumper))) [at 0 ticked, at 0.05 bump, at 0.1 ticked]
        @?= ["Say \"Nothing\"", "Say \"Just (Bumper LeftBumper Pressed)\"", "Say \"Nothing\""],
    testCase "an unused value waits while the other side comes and goes" $
      commandsOf (\e b -> Say (show (either (const 'p') (const 'b') (e :: Either (Cliff, Button) Bumper), b :: ButtonOne))) [at 0.1 hole, at 0.2 bump, at 0.3 (sensed (ButtonMessage (Button Button1 Pressed)))]
        @?= ["Say \"('p',ButtonOne Pressed)\""]
  ]

waiting :: [TestTree]
waiting =
  [ testCase "events that come before odometry are handled when it comes, each of them" $
      told (\(Bumper _ s) (Velocity v _) -> Say (show (s, v))) [at 0 bump, at 0.01 unbump, at 0.02 (moving 1), at 0.04 still]
        @?= [(0.02, "Say \"(Pressed,1.0)\""), (0.02, "Say \"(Released,1.0)\"")]
  ]

transactions :: [TestTree]
transactions =
  [ testCase "a later function in the same instant sees the new memory" $
      commandsOf (\(Bumper _ s) -> Memory (s == Pressed), \(Bumper _ _) (Memory b) -> Say (show (b :: Bool))) [at 0 bump]
        @?= ["Say \"True\""],
    testCase "an earlier one sees it next time" $
      commandsOf (\(Bumper _ _) (Memory b) -> Say (show (b :: Bool)), \(Bumper _ s) -> Memory (s == Pressed)) [at 0 bump, at 0.1 bump]
        @?= ["Say \"False\"", "Say \"True\""],
    testCase "a function that fails writes nothing of what it would have written" $ do
      let story = hear (\(Bumper _ s) -> (Memory (1 :: Int), if s == Pressed then Say "ok" else Say (errorWithoutStackTrace "no"))) [at 0 bump, at 0.1 unbump]
      concatMap heardCommands story @?= ["Say \"ok\""]
      heardEnd (last story) @?= Just "Failed",
    testCase "functions fire in the order in which the program lists them" $
      firedIn (Names [Name "a", Names [Name "b", Name "c"]]) (\b -> nothing' (b :: Bumper), (\b -> nothing' (b :: Bumper), \b -> nothing' (b :: Bumper))) [at 0 bump]
        @?= ["a", "b", "c"]
  ]
  where
    nothing' :: a -> ()
    nothing' _ = ()

memories :: [TestTree]
memories =
  [ testCase "begins at False, 0, the empty list, the first constructor" $
      commandsOf (\(Memory a, Memory b, Memory c, Memory d, Memory e) -> Say (show (a :: Bool, b :: Int, c :: String, d :: Maybe Int, e :: LedColor))) [at 0 ticked]
        @?= ["Say \"(False,0,\\\"\\\",Nothing,Black)\""],
    testCase "keeps what was written" $
      commandsOf (\() (Memory n) -> (Memory (n + 1 :: Int), Say (show n))) [at 0 ticked, at 0.1 ticked, at 0.2 ticked]
        @?= ["Say \"0\"", "Say \"1\"", "Say \"2\""],
    testCase "is one per type, shared by the functions" $
      commandsOf (\() -> Memory (Pair 1 (2 :: Int)), \(Memory (Pair a b)) -> Say (show (a + b :: Int))) [at 0 ticked]
        @?= ["Say \"3\""]
  ]

users :: [TestTree]
users =
  [ testCase "are delivered in the same instant, after all functions had their turn" $
      told (\(Bumper _ _) -> Ping 1, \(Ping n) -> Say ("ping " ++ show n), \(Bumper _ _) -> Say "bump") [at 0.1 bump]
        @?= [(0.1, "Say \"bump\""), (0.1, "Say \"ping 1\"")],
    testCase "go to every function that takes them" $
      commandsOf (\(Bumper _ _) -> Ping 1, \(Ping _) -> Led1 Red, \(Ping _) -> Led2 Red) [at 0 bump] @?= ["Led1 Red", "Led2 Red"],
    testCase "each element of a list is an event of its own" $
      commandsOf (\(Bumper _ _) -> [Ping 1, Ping 2, Ping 3], \(Ping n) -> Say (show n)) [at 0 bump] @?= ["Say \"1\"", "Say \"2\"", "Say \"3\""],
    testCase "may carry a type parameter, and then the parameter counts" $
      commandsOf (\(Bumper _ _) -> (Pair 'a' 'b', Pair True False), \(Pair a b) -> Say [b, a]) [at 0 bump] @?= ["Say \"ba\""],
    testCase "are gone when they are not taken" $
      commandsOf (\(Bumper _ _) -> Ping 1) [at 0 bump, at 1 bump] @?= [],
    testCase "two functions that feed each other do not stop the world" $ do
      let story = hear (\b p -> pong (b :: Maybe Bumper) p, \(Button _ _) -> Say "still here", \(Bumper _ _) -> Ping 0, \(Ping n) -> Ping (n + 1)) [at 0 bump, at 0.1 push]
      concatMap heardCommands story @?= ["Say \"still here\""]
      map (length . heardFired) story @?= [0, 2 + 64, 1 + 64],
    testCase "are heard in a trace with their values" $
      concatMap heardEvents (hear (\(Bumper _ _) -> Ping 4) [at 0 bump]) @?= ["Bumper LeftBumper Pressed", "Ping 4"]
  ]
  where
    pong :: Maybe Bumper -> Memory (Maybe Bool) -> ()
    pong _ _ = ()

outputs :: [TestTree]
outputs =
  [ testCase "commands go out in firing order" $
      commandsOf (Led1 Green, [Velocity 0.1 0, Velocity 0.2 0], Led2 Red) [at 0 ticked]
        @?= ["Led1 Green", "Velocity 0.1 0.0", "Velocity 0.2 0.0", "Led2 Red"],
    testCase "velocity as a command is not velocity as a sensor" $
      commandsOf (Velocity 0.5 0, \(Velocity v _) -> Say (show v)) [at 0 ticked, at 0 still] @?= ["Velocity 0.5 0.0", "Say \"0.0\""],
    testCase "tuples give all, Either one, Maybe perhaps, a list each, () nothing" $
      commandsOf (\(Bumper _ s) -> ((Led1 Red, Just (Led2 Red)), if s == Pressed then Left ErrorSound else Right [Say "a", Say "b"], ())) [at 0 bump, at 0.1 unbump]
        @?= ["Led1 Red", "Led2 Red", "ErrorSound", "Led1 Red", "Led2 Red", "Say \"a\"", "Say \"b\""],
    testCase "nine outputs are possible" $
      commandsOf (\(Bumper _ _) -> (Led1 Red, Led2 Red, Say "", OnSound, Velocity 0 0, (), Never, Nothing :: Maybe Led1, Led1 Black)) [at 0 bump]
        @?= ["Led1 Red", "Led2 Red", "Say \"\"", "OnSound", "Velocity 0.0 0.0", "Led1 Black"],
    testCase "a function inside an output adds its inputs" $
      commandsOf (\(Bumper _ s) -> if s == Pressed then Just (\t -> Say (show (t :: Seconds))) else Nothing) [at 0.5 bump, at 0.6 unbump]
        @?= ["Say \"Seconds 0.5\""],
    testCase "a speed that is not a number ends the program, and names the function" $
      concatMap heardFired (hear (\(Bumper _ _) -> Velocity (0 / 0) 0) [at 0 bump]) @?= ["function 1", "failed: NotANumber \"speed\""]
  ]

controllers :: [TestTree]
controllers =
  [ testCase "a list of controllers is a controller" $
      commandsOf [\(Bumper _ _) -> Say (show n) | n <- [1 .. 3 :: Int]] [at 0 bump] @?= ["Say \"1\"", "Say \"2\"", "Say \"3\""],
    testCase "nine controllers fit a tuple, and tuples nest" $
      length (commandsOf (Led1 Red, Led1 Red, Led1 Red, Led1 Red, Led1 Red, Led1 Red, Led1 Red, Led1 Red, (Led1 Red, [Led1 Red])) [at 0 ticked]) @?= 10,
    testCase "names of another shape fall back to numbers, one name serves many" $ do
      firedIn (Names [Name "a"]) (Led1 Red, Led2 Red) [at 0 ticked] @?= ["function 1", "function 2"]
      firedIn (Name "both") (Led1 Red, Led2 Red) [at 0 ticked] @?= ["both", "both"]
      firedIn (Names [Name "a", Names []]) (Led1 Red, Led2 Red) [at 0 ticked] @?= ["a", "function 2"],
    testCase "an empty list does nothing" $
      commandsOf ([] :: [Led1]) [at 0 ticked, at 0 still] @?= []
  ]
