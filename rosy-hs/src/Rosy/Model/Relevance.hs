-- |
-- Module      : Rosy.Model.Relevance
-- Description : Which happenings a part of the program's state may depend on (rule R12).
--
-- Each place where the past is kept has a label: the numbers of the instants that it may depend on. A firing has the labels of its
-- cause and of what it reads; what it gives has the label of the firing. Since a function is opaque, a place that it may write has
-- that label also when it does not write it: with another input it might have. What a function may give is known from its type.
--
-- Whether a task lives is one place for the whole program ('TaskTree'): all that may end, begin or call a task is a cause
-- of all that happens afterwards. This is coarse and safe.
module Rosy.Model.Relevance
  ( Label,
    Place (..),
    Labels,
    noLabels,
    labelOf,
    replaceLabel,
    addLabel,

    -- * User events that might have been sent
    Phantoms,
    noPhantoms,
    addPhantom,
    phantoms,
  )
where

import Data.IntSet (IntSet)
import qualified Data.IntSet as IntSet
import Data.Map (Map)
import qualified Data.Map as Map
import Rosy.Model.Program (Type)

-- | Numbers of instants.
type Label = IntSet

-- | Where the past is kept.
data Place
  = -- | The memory of a type, by scope.
    Remembered Int Type
  | -- | What odometry said last.
    Measured
  | -- | That odometry has arrived.
    FirstMeasured
  | -- | How many random generators were read.
    Generators
  | -- | Which tasks live.
    TaskTree
  | -- | The values that a function keeps until their partners come, by the function's number.
    Kept Int
  deriving (Eq, Ord, Show)

-- | The label of each place.
type Labels = Map Place Label

-- | Nothing depends on anything.
noLabels :: Labels
noLabels = Map.empty

-- | On what a place depends.
labelOf :: Place -> Labels -> Label
labelOf = Map.findWithDefault IntSet.empty

-- | The place was written: what it depended on before does not matter any more.
replaceLabel :: Place -> Label -> Labels -> Labels
replaceLabel = Map.insert

-- | The place might have been written.
addLabel :: Place -> Label -> Labels -> Labels
addLabel = Map.insertWith IntSet.union

-- | By type, the label of events that were not sent in this instant and might have been.
type Phantoms = Map Type Label

-- | None.
noPhantoms :: Phantoms
noPhantoms = Map.empty

-- | One more.
addPhantom :: Type -> Label -> Phantoms -> Phantoms
addPhantom = Map.insertWith IntSet.union

-- | All of them.
phantoms :: Phantoms -> [(Type, Label)]
phantoms = Map.toList
