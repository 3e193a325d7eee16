{-# LANGUAGE DeriveGeneric #-}
{-# OPTIONS_GHC -fdefer-type-errors -Wno-deferred-type-errors #-}

-- |
-- Module      : Test.Rosy.Refused
-- Description : What does not compile, and must not.
--
-- Type errors are put off to the run here, so that a refusal is a value that can be looked at.
module Test.Rosy.Refused (tests) where

import Control.Exception (TypeError (..), evaluate, try)
import Data.List (isInfixOf)
import GHC.Generics (Generic)
import Rosy
import Rosy.Program
import Support.Story
import Test.Tasty (TestTree, testGroup)
import Test.Tasty.HUnit

newtype NoDefault = NoDefault (IO ())
  deriving (Generic)

instance Value NoDefault

instance Sensor NoDefault

instance Command NoDefault

tests :: TestTree
tests =
  testGroup
    "Refused before it runs"
    [ refused "an Int as a sensor" "Sensor Int" (commandsOf (\n -> Led1 (toEnum (n :: Int))) story),
      refused "a text as a sensor" "Sensor Char" (commandsOf (\s -> Say (s :: String)) story),
      refused "a Bool as a command" "Command Bool" (commandsOf (\(Bumper _ s) -> s == Pressed) story),
      refused "an Int as a controller" "Command Int" (commandsOf (3 :: Int) story),
      refused "a color that is not put on a light" "Command LedColor" (commandsOf Red story),
      refused "a Done of another type than the task's" "()" doneOfAnother,
      refused "a Done of another type, deep inside" "()" doneDeepInside,
      refused "a Done outside a task" "NotInATask" doneOutside,
      refused "a Done in once" "NotInATask" doneInOnce,
      refused "a memory of something without a beginning" "Default (IO ())" [(defaultValue :: IO ()) `seq` ""],
      testCase "but a declared type is both a sensor and a command" $
        commandsOf (\() -> NoDefault (pure ()), \(NoDefault _) -> Led1 Red) story @?= ["Led1 Red"]
    ]

story :: [Moment]
story = [at 0 ticked, at 0 still]

-- These are equalities between types, whose errors would otherwise be those of the whole list.
doneOfAnother :: [String]
doneOfAnother = commandsOf (task () (\(Bumper _ _) -> Done 'x') :: Task ()) story

doneDeepInside :: [String]
doneDeepInside = commandsOf (task () (Led1 Red, \(Bumper _ _) -> [Left (Led2 Red), Right (Just (Done 'x'))]) :: Task ()) story

doneOutside :: [String]
doneOutside = commandsOf (\(Bumper _ _) -> Done ()) story

doneInOnce :: [String]
doneInOnce = commandsOf (once (Done ())) story

-- | Evaluating this is a type error that mentions so much.
refused :: String -> String -> [String] -> TestTree
refused title mention result = testCase title $ do
  outcome <- try (evaluate (length (concat result)))
  case outcome of
    Left (TypeError text) -> unless (mention `isInfixOf` text) (ioError (userError text))
    Right _ -> ioError (userError "it was not refused")
