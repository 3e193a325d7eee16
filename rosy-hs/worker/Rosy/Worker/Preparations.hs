-- |
-- Module      : Rosy.Worker.Preparations
-- Description : Runs that are compiled before they are asked for.
--
-- A preparation keeps the robot link of its run. A child compiles the program and waits before @main@; one that is lost, or is ended
-- because memory is short, costs time only: the run is then compiled as any other. Pure.
module Rosy.Worker.Preparations
  ( Preparations,
    noPreparations,
    Preparation (..),
    Stage (..),
    addPreparation,
    takePreparation,
    nextPreparation,
    withChild,
    withoutChild,
  )
where

import Data.Aeson (Value)
import Data.List (partition)
import Rosy.Worker.Protocol (Order)
import Rosy.Worker.SystemCalls (Link)

data Preparation = Preparation
  { -- | Id of the run.
    runId :: Value,
    link :: Link,
    stage :: Stage
  }
  deriving (Eq, Show)

data Stage
  = -- | No child has begun with it.
    Queued Order
  | -- | Process id of the child.
    Child Int
  | -- | Its child is no more.
    Lost
  deriving (Eq, Show)

-- | The oldest first.
newtype Preparations = Preparations [Preparation]
  deriving (Eq, Show)

noPreparations :: Preparations
noPreparations = Preparations []

-- | One more, or the reason why there cannot be one.
addPreparation :: Preparation -> Preparations -> Either String Preparations
addPreparation new (Preparations known)
  | any ((== runId new) . runId) known = Left "This run is prepared already."
  | length known >= maxPreparations = Left ("At most " ++ show maxPreparations ++ " runs are prepared at once.")
  | otherwise = Right (Preparations (known ++ [new]))

-- | The service prepares fewer (@Limits.prepared@).
maxPreparations :: Int
maxPreparations = 64

-- | The preparation of a run, and the others.
takePreparation :: Value -> Preparations -> Maybe (Preparation, Preparations)
takePreparation i (Preparations known) = case partition ((== i) . runId) known of
  ([p], others) -> Just (p, Preparations others)
  _ -> Nothing

-- | The one that a child can begin with.
nextPreparation :: Preparations -> Maybe (Value, Link, Order)
nextPreparation (Preparations known) = case [(runId p, link p, order) | p@Preparation {stage = Queued order} <- known] of
  first : _ -> Just first
  [] -> Nothing

-- | A child compiles this run.
withChild :: Value -> Int -> Preparations -> Preparations
withChild i pid = change (\p -> if runId p == i then p {stage = Child pid} else p)

-- | This child is no more, or has refused the program.
withoutChild :: Int -> Preparations -> Preparations
withoutChild pid = change (\p -> if stage p == Child pid then p {stage = Lost} else p)

change :: (Preparation -> Preparation) -> Preparations -> Preparations
change f (Preparations known) = Preparations (map f known)
