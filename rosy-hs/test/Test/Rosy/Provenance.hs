{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Test.Rosy.Provenance
-- Description : The runtime records the provenance that the model defines (rule R12).
--
-- Causes, reads with their versions and outputs of every firing are read from the lines that a link would carry.
module Test.Rosy.Provenance (tests) where

import Data.Aeson (object, (.=))
import qualified Data.Aeson as Aeson
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Aeson.Types (Pair)
import qualified Data.IntSet as IntSet
import Data.List (mapAccumL)
import Rosy.Model hiding (Read, reads, tasks)
import qualified Rosy.Model as Model
import Support.Generated
import Support.Rehearsal
import Support.Translated
import Test.QuickCheck (Property, arbitrary, conjoin, counterexample, cover, forAll, forAllShrink, ioProperty, tabulate, vectorOf, (.&&.), (===))
import Test.Tasty (TestTree, adjustOption, testGroup)
import Test.Tasty.HUnit
import Test.Tasty.QuickCheck (QuickCheckTests (..), testProperty)

-- | With so many generated programs for each property.
tests :: Int -> TestTree
tests cases =
  adjustOption (max (QuickCheckTests cases)) . testGroup "Provenance: the runtime records what the model says" $
    [ testProperty "for controllers" (forAllShrink controllers (const []) (\(Shown _ p) -> agree p)),
      testProperty "for tasks" (forAllShrink tasks (const []) (\(Shown _ p) -> agree p)),
      testProperty "for tasks that fail or are stopped" (forAllShrink fragile (const []) (\(Shown _ p) -> agree p)),
      testProperty "law of irrelevance, for controllers" (forAllShrink controllers (const []) (\(Shown _ p) -> irrelevant p)),
      testProperty "law of irrelevance, for tasks" (forAllShrink tasks (const []) (\(Shown _ p) -> irrelevant p)),
      testGroup
        "a command depends on"
        [ testCase "the newest write of a memory, not on older ones" $ needs [remember, tell] [bump 1, bump 3, Tick] @?= [0, 2, 3],
          testCase "a write that could have come between" $ needs [remember, perhaps, tell] [bump 1, button, Tick] @?= [0, 1, 2, 3],
          testCase "a user event that could have been sent" $ needs [remember, gate, store, tell1] [bump 1, bump 2, button, Tick] @?= [0, 2, 3, 4],
          testCase "earlier readers of random generators" $ needs [Function "reader" (All [Event "Bumper", Chance]) [] (const []), silent, throw] [bump 1, button, Tick] @?= [0, 1, 3],
          testCase "the partner that an event waited for" $ needs [Function "both" (All [Event "Bumper", Event "Button"]) [] (\v -> [Command v])] [bump 1, Odometry 1, button] @?= [0, 1, 3],
          testCase "the latest odometry, not on older ones" $ needs [Function "go" (All [Event "Button", State]) [] (\v -> [Command v])] [Odometry 1, Odometry 2, Odometry 3, button] @?= [0, 1, 3, 4]
        ]
    ]
  where
    agree p (Days days) =
      let expected = told (provenance p days)
       in cover 30 (length expected > 2) "programs in which functions fire" . tabulate "causes" (map (kind . cause) (provenance p days)) $
            ioProperty (counterexample "the runtime, then the model:" . (=== expected) . map withoutValues . concatMap heardFirings <$> rehearse (cues days) (translated p))
    kind = takeWhile (/= ' ') . show

-- | The instants that the last command of these functions depends on, when these happenings follow a tick.
needs :: [Function] -> [Happening] -> [Int]
needs functions' happenings = last [IntSet.toList (dependsOn f) | f <- provenance p (zip [0 ..] (Tick : happenings)), Command _ <- gave f]
  where
    p = Task (Spec "Nothing" Nothing functions' [] Nothing) Return

bump :: Int -> Happening
bump = Happens "Bumper" . Int

button :: Happening
button = Happens "Button" (Int 0)

remember, perhaps, gate, store, tell, tell1, silent, throw :: Function
remember = Function "remember" (Event "Bumper") [MayWrite "M0"] (\v -> [Write "M0" v])
perhaps = Function "perhaps" (Event "Button") [MayWrite "M0"] (const [])
gate = Function "gate" (All [Event "Button", Memory "M0"]) [MayEmit "E0"] (\v -> [Emit "E0" v | v == Tuple [Int 0, Int 1]])
store = Function "store" (Event "E0") [MayWrite "M1"] (\v -> [Write "M1" v])
tell = Function "tell" (All [Event "()", Memory "M0"]) [] (\v -> [Command v])
tell1 = Function "tell1" (All [Event "()", Memory "M1"]) [] (\v -> [Command v])
silent = Function "silent" (Event "Button") [] (const [])
throw = Function "throw" (All [Event "()", Chance]) [] (\v -> [Command v])

-- | What does not belong to the transitive causes and reads of a firing that gives a command can be left out, all of it or a part:
-- the function fires at the same time, with the same values.
irrelevant :: Program -> Days -> Property
irrelevant p (Days days) =
  cover 30 (not (null firings)) "programs that give commands" . cover 15 (any removable firings) "runs with something to leave out" $
    forAll (vectorOf (length days) arbitrary) $ \chosen ->
      conjoin [still f (without f (const True)) .&&. still f (without f (chosen !!)) | f <- firings]
  where
    firings = [f | f <- provenance p days, not (null (commands f))]
    without f leaveOut = [day | (n, day) <- zip [0 ..] days, n `IntSet.member` dependsOn f || not (leaveOut n)]
    removable f = IntSet.size (dependsOn f) < length days
    still f days' =
      counterexample ("without " ++ show (length days - length days') ++ " happenings: " ++ show days' ++ "\ndepends on " ++ show (dependsOn f)) $
        counterexample (show (seen f) ++ " is not among " ++ show (map seen (provenance p days'))) (seen f `elem` map seen (provenance p days'))
    seen f = (firedAt f, firedBy f, map snd (Model.reads f), commands f)
    commands f = [show v | Command v <- gave f] ++ [show v | Drive v <- gave f]

-- | The firings of the model as the link carries them, without values: those are compared where commands are.
told :: [Firing] -> [Aeson.Value]
told = snd . mapAccumL one 0 . zip [0 :: Int ..]
  where
    one emitted (number, f) =
      let (emitted', outputs) = mapAccumL output emitted (gave f)
       in ( emitted',
            object
              [ "n" .= number,
                "function" .= firedBy f,
                "task" .= inTask f,
                "cause" .= object (reason (cause f)),
                "took" .= map (object . source . fst) (Model.reads f),
                -- The translation says each firing aloud.
                "gave" .= (object (command "Say") : map object outputs)
              ]
          )

-- | An output, after so many user events.
output :: Int -> Output -> (Int, [Pair])
output emitted out = case out of
  Command _ -> (emitted, command "Say")
  Drive _ -> (emitted, command "Velocity")
  Light _ -> (emitted, command "Led1")
  Arbitrated _ o -> output emitted o
  Write t _ -> (emitted, to "memory" ++ ["type" .= ("Memory " ++ t)])
  Share t _ -> (emitted, to "param" ++ ["type" .= ("Param " ++ t)])
  Emit t _ -> (emitted + 1, to "event" ++ ["type" .= t, "event" .= emitted])
  Done _ _ -> (emitted, to "done")
  Feedback _ -> (emitted, to "feedback")
  Call _ -> (emitted, to "call")
  Fail -> (emitted, to "nothing")
  where
    to what = ["to" .= (what :: String)]

-- | A command of a type.
command :: String -> [Pair]
command what = ["to" .= ("command" :: String), "type" .= what]

reason :: Cause -> [Pair]
reason why = case why of
  Occurred n -> by "occurrence" ++ ["instant" .= n]
  Received n f -> by "event" ++ ["event" .= n, "firing" .= f]
  Began -> by "start"
  Resumed n -> by "instant" ++ ["instant" .= n]
  Followed n -> by "task" ++ ["firing" .= n]
  Ended -> by "end"
  where
    by what = ["by" .= (what :: String)]

source :: Model.Read -> [Pair]
source from = case from of
  ReadEvent -> ["from" .= ("event" :: String)]
  ReadState n -> ["from" .= ("state" :: String), "channel" .= ("Odometry" :: String), "instant" .= n]
  ReadMemory t w -> ["from" .= ("memory" :: String), "type" .= ("Memory " ++ t)] ++ maybe [] (\n -> ["firing" .= n]) w
  ReadParam t w -> ["from" .= ("param" :: String), "type" .= ("Param " ++ t)] ++ maybe [] (\n -> ["firing" .= n]) w
  ReadTime -> ["from" .= ("time" :: String)]
  ReadChance n -> ["from" .= ("generator" :: String), "read" .= n]

-- | A line's firing without its values. The model does not tell a tick from a message.
withoutValues :: Aeson.Value -> Aeson.Value
withoutValues value = case value of
  Aeson.Object o -> Aeson.Object (fmap withoutValues (KeyMap.delete "value" o))
  Aeson.Array xs -> Aeson.Array (fmap withoutValues xs)
  Aeson.String s | s `elem` ["message", "tick"] -> "occurrence"
  other -> other
