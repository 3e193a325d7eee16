-- |
-- Module      : Rosy.Worker.MemoryCeiling
-- Description : Which child processes have to end so that all together stay below a ceiling of memory.
--
-- Takes the memory of each child as the kernel counts it; decides, but ends nothing. The limits of each single child are set in
-- "Rosy.Worker.ChildProcess"; this is the limit of their sum. Pure.
module Rosy.Worker.MemoryCeiling
  ( Usage (..),
    Activity (..),
    Ceilings (..),
    ceilings,
    overdraft,
    compilingInterval,
    runningInterval,
  )
where

import Data.List (sortOn)
import Data.Ord (Down (..))
import Data.Word (Word64)

-- | What a child does, in the order in which children are ended.
data Activity
  = -- | Its program is compiled, or is being compiled, in case that it will be run.
    Prepared
  | Compiling
  | Running
  deriving (Eq, Ord, Show)

-- | Memory of one child, bytes beyond what it shares with the worker, and what it does.
data Usage = Usage
  { process :: Int,
    activity :: Activity,
    bytes :: Word64
  }
  deriving (Eq, Show)

-- | Bytes.
data Ceilings = Ceilings
  { -- | For all children that compile or have a program prepared.
    compilingTotal :: Word64,
    -- | For all children.
    allTotal :: Word64
  }

-- | From the ceiling of all children and the limit of one compilation: as much as two compilations may take, whatever their number.
ceilings :: Word64 -> Word64 -> Ceilings
ceilings all' each = Ceilings {compilingTotal = min all' (2 * each), allTotal = all'}

-- | The children to end: the largest first, until the rest fits. What is only prepared goes before a child that compiles, and that before a
-- program that runs.
overdraft :: Ceilings -> [Usage] -> [Int]
overdraft limits usages = map process (compilers ++ others)
  where
    compilers = tooMany (compilingTotal limits) (filter ((/= Running) . activity) usages)
    left = filter (`notElem` compilers) usages
    others = tooMany (allTotal limits) left

-- | What to remove from the usages so that their sum is at most the limit.
tooMany :: Word64 -> [Usage] -> [Usage]
tooMany limit usages = go (sum (map bytes usages)) (sortOn (\u -> (activity u, Down (bytes u))) usages)
  where
    go _ [] = []
    go now (u : us)
      | now <= limit = []
      | otherwise = u : go (now - bytes u) us

-- | Seconds between two looks while a child compiles. A compilation allocates some 300 MB a second, so all of them pass the ceiling by some
-- 15 MB for each processor before they are seen.
compilingInterval :: Double
compilingInterval = 0.05

-- | Seconds between two looks while programs only run.
runningInterval :: Double
runningInterval = 0.5
