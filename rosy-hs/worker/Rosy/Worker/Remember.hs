-- |
-- Module      : Rosy.Worker.Remember
-- Description : What was answered lately, within a bound of bytes: what has not been asked for longest goes first.
--
-- Pure, but for the two functions at the end. They keep bytes outside of the collector's heap: what lives for minutes there is moved
-- to where it is looked at last, next to the compiler, and the worker grew by 90 MB before it was. Here it is given back at once.
module Rosy.Worker.Remember
  ( Remembered,
    nothingYet,
    recall,
    remember,
    held,

    -- * Bytes outside of the heap
    outside,
    giveBack,
  )
where

import Data.ByteString (ByteString)
import Data.ByteString.Unsafe (unsafeFinalize, unsafePackMallocCStringLen, unsafeUseAsCStringLen)
import qualified Data.IntMap.Strict as IntMap
import qualified Data.Map.Strict as Map
import Foreign.Marshal.Alloc (mallocBytes)
import Foreign.Marshal.Utils (copyBytes)

-- | Answers by question.
data Remembered k v = Remembered
  { clock :: !Int,
    size :: !Int,
    entries :: !(Map.Map k (Entry v)),
    -- | By when they were asked for last.
    order :: !(IntMap.IntMap k)
  }

data Entry v = Entry !Int !Int !v

nothingYet :: Remembered k v
nothingYet = Remembered 0 0 Map.empty IntMap.empty

-- | How much is held, in what 'remember' counts.
held :: Remembered k v -> Int
held = size

-- | An answer that is there, which is then the youngest.
recall :: Ord k => k -> Remembered k v -> Maybe (v, Remembered k v)
recall question r = do
  -- The key that is there, and not the one that asks: it may be kept outside of the heap.
  (key, Entry cost age answer) <- (`Map.elemAt` entries r) <$> Map.lookupIndex question (entries r)
  let now = clock r + 1
  Just
    ( answer,
      r
        { clock = now,
          entries = Map.adjust (const (Entry cost now answer)) question (entries r),
          order = IntMap.insert now key (IntMap.delete age (order r))
        }
    )

-- | With one more answer of this size, and what had to go for it: other answers, or the new one when it alone is too large or is
-- there already.
remember :: Ord k => Int -> k -> Int -> v -> Remembered k v -> ([(k, v)], Remembered k v)
remember most question cost answer r
  | cost > most || Map.member question (entries r) = ([(question, answer)], r)
  | otherwise =
    shrink
      []
      r
        { clock = now,
          size = size r + cost,
          entries = Map.insert question (Entry cost now answer) (entries r),
          order = IntMap.insert now question (order r)
        }
  where
    now = clock r + 1
    shrink gone s
      | size s > most,
        Just (oldest, rest) <- IntMap.minView (order s),
        Just (Entry c _ a) <- Map.lookup oldest (entries s) =
        shrink ((oldest, a) : gone) s {size = size s - c, entries = Map.delete oldest (entries s), order = rest}
      | otherwise = (gone, s)

-- | A copy that the collector does not see.
outside :: ByteString -> IO ByteString
outside bytes = unsafeUseAsCStringLen bytes $ \(from, n) -> do
  copy <- mallocBytes (max 1 n)
  copyBytes copy from n
  unsafePackMallocCStringLen (copy, n)

-- | Frees such a copy. Nobody may look at it any more.
giveBack :: ByteString -> IO ()
giveBack = unsafeFinalize
