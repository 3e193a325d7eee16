{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Graph
-- Description : Structure of the network that a program runs: functions, tasks and steps.
--
-- Data types and JSON encodings of @graph@ in "protocol/README.md", section 3. Pure. "Rosy.Worker.Ghc.ProgramGraph" makes the values.
module Rosy.Worker.Graph
  ( Part (..),
    Chart (..),
    Shape (..),
    Connection (..),
    ConnectionUse (..),
    usedTypes,
  )
where

import Data.Aeson (Series, ToJSON (..), object, pairs, (.=))
import Data.Aeson.Types (Pair)
import qualified Data.Set as Set
import Data.Text (Text)
import Rosy.Worker.Problem (Position (..), Span (..))

-- | A part of a controller or a task. Without a place it is not in the text.
data Part
  = -- | A function with its inputs and its output.
    FunctionPart {partName :: !Text, partPlace :: !(Maybe Span), takes :: ![Shape], gives :: !Shape}
  | -- | @task start controller@: what is carried out once, then what runs until @Done@.
    TaskPart {partName :: !Text, partPlace :: !(Maybe Span), begins :: ![Part], runs :: ![Part]}
  | -- | Tasks that are composed; the number of turns of a repetition, if it is written as a number.
    ChartPart {partName :: !Text, partPlace :: !(Maybe Span), chart :: !Chart, turns :: !(Maybe Integer), steps :: ![Part]}
  | -- | A task that is not composed further: of the library, from a parameter, or one that is already open around it.
    StepPart {partName :: !Text, partPlace :: !(Maybe Span)}
  deriving (Eq, Show)

data Chart = Sequence | Repeat | Parallel | Race | Choice
  deriving (Eq, Show)

-- | An input or an output by the rules R14 and R15.
data Shape
  = AllOf ![Shape]
  | EitherOf ![Shape]
  | MaybeOf !Shape
  | EachOf !Shape
  | -- | A type as it is written and without synonyms, whether it is an event among the functions of the program, and its topic where the program
    -- connects it to one.
    Leaf {written :: !Text, spelled :: !Text, isOwn :: !Bool, onTopic :: !(Maybe Connection)}
  deriving (Eq, Show)

-- | A type of the program that is connected to a topic (rule R23). A name that is computed while the program runs is not known.
data Connection = Connection
  { connectedType :: !Text,
    connectionUse :: !ConnectionUse,
    connectionName :: !(Maybe Text),
    connectionMessage :: !(Maybe Text),
    -- | Paths of the fields that are read.
    connectionFields :: ![Text]
  }
  deriving (Eq, Show)

data ConnectionUse = Taken | Sent
  deriving (Eq, Show)

-- | The types of the library that the functions and ready-made tasks of these parts take and give, each once, in alphabetical order.
usedTypes :: [Part] -> [Text]
usedTypes = Set.toAscList . foldMap used
  where
    used part = case part of
      FunctionPart {} -> foldMap leaves (gives part : takes part)
      TaskPart {} -> foldMap used (begins part ++ runs part)
      ChartPart {} -> foldMap used (steps part)
      StepPart {} -> Set.fromList [t | (task, types) <- typesInTasks, task == partName part, t <- types]
    leaves shape = case shape of
      AllOf shapes -> foldMap leaves shapes
      EitherOf shapes -> foldMap leaves shapes
      MaybeOf inner -> leaves inner
      EachOf inner -> leaves inner
      Leaf {} -> if isOwn shape then Set.empty else Set.singleton (spelled shape)

-- | What the ready-made tasks ("Rosy.Motion") need of a robot that not every robot has.
typesInTasks :: [(Text, [Text])]
typesInTasks =
  [ ("beep", ["Sound"]),
    ("blink", ["Led1"]),
    ("curveUntilObstacle", ["Bumper", "Cliff"]),
    ("driveUntilBump", ["Bumper"]),
    ("penColor", ["PenColor"]),
    ("penDown", ["Pen"]),
    ("penUp", ["Pen"]),
    ("penWidth", ["PenWidth"])
  ]

instance ToJSON Part where
  toJSON part = case part of
    FunctionPart {} -> object (("inputs" .= takes part) : ("output" .= gives part) : common)
    TaskPart {} -> object (("start" .= begins part) : ("parts" .= runs part) : common)
    ChartPart {} -> object (("steps" .= steps part) : maybe [] (\n -> ["turns" .= n]) (turns part) ++ common)
    StepPart {} -> object common
    where
      common = ["kind" .= kindOf part, "name" .= partName part] ++ maybe [] (\s -> ["at" .= spanNumbers s]) (partPlace part)
  toEncoding part = pairs $ case part of
    FunctionPart {} -> common <> "inputs" .= takes part <> "output" .= gives part
    TaskPart {} -> common <> "start" .= begins part <> "parts" .= runs part
    ChartPart {} -> common <> maybe mempty ("turns" .=) (turns part) <> "steps" .= steps part
    StepPart {} -> common
    where
      common :: Series
      common = "kind" .= kindOf part <> "name" .= partName part <> maybe mempty (("at" .=) . spanNumbers) (partPlace part)

kindOf :: Part -> Text
kindOf part = case part of
  FunctionPart {} -> "function"
  TaskPart {} -> "task"
  StepPart {} -> "step"
  ChartPart {} -> case chart part of
    Sequence -> "sequence"
    Repeat -> "repeat"
    Parallel -> "parallel"
    Race -> "race"
    Choice -> "choice"

-- | Line, column, end line and end column.
spanNumbers :: Span -> [Int]
spanNumbers (Span from to) = [line from, column from, line to, column to]

instance ToJSON Shape where
  toJSON shape = case shape of
    AllOf xs -> object ["all" .= xs]
    EitherOf xs -> object ["either" .= xs]
    MaybeOf x -> object ["maybe" .= x]
    EachOf x -> object ["each" .= x]
    Leaf {} -> object (["type" .= written shape] ++ ["is" .= spelled shape | spelled shape /= written shape] ++ ["own" .= True | isOwn shape] ++ maybe [] (\c -> ["topic" .= object (topicMembers c)]) (onTopic shape))
  toEncoding shape = pairs $ case shape of
    AllOf xs -> "all" .= xs
    EitherOf xs -> "either" .= xs
    MaybeOf x -> "maybe" .= x
    EachOf x -> "each" .= x
    Leaf {} -> "type" .= written shape <> (if spelled shape /= written shape then "is" .= spelled shape else mempty) <> (if isOwn shape then "own" .= True else mempty) <> maybe mempty (\c -> "topic" .= object (topicMembers c)) (onTopic shape)

-- | The topic's name and the type of its messages, as far as they are known.
topicMembers :: Connection -> [Pair]
topicMembers c = maybe [] (\n -> ["name" .= n]) (connectionName c) ++ maybe [] (\t -> ["type" .= t]) (connectionMessage c)

instance ToJSON Connection where
  toJSON c = object (["of" .= connectedType c, "use" .= useText, "fields" .= connectionFields c] ++ topicMembers c)
    where
      useText :: Text
      useText = case connectionUse c of
        Taken -> "take"
        Sent -> "send"
