-- |
-- Module      : Rosy.Worker.LruCache
-- Description : LRU cache bounded by a total size.
--
-- Pure, except for the two functions that copy bytes off the garbage-collected heap. Cached bytes are kept off the heap because the
-- copying collector moves long-lived objects next to the compiler's data, which grew the worker by 90 MB.
module Rosy.Worker.LruCache
  ( LruCache,
    emptyCache,
    lookupEntry,
    insertEntry,
    totalSize,

    -- * Bytes off the heap
    copyOffHeap,
    freeOffHeap,
  )
where

import Data.ByteString (ByteString)
import Data.ByteString.Unsafe (unsafeFinalize, unsafePackMallocCStringLen, unsafeUseAsCStringLen)
import qualified Data.IntMap.Strict as IntMap
import qualified Data.Map.Strict as Map
import Foreign.Marshal.Alloc (mallocBytes)
import Foreign.Marshal.Utils (copyBytes)

-- | Cached values by key.
data LruCache k v = LruCache
  { clock :: !Int,
    size :: !Int,
    entries :: !(Map.Map k (Entry v)),
    -- | Keys by the time of their last use.
    order :: !(IntMap.IntMap k)
  }

data Entry v = Entry !Int !Int !v

emptyCache :: LruCache k v
emptyCache = LruCache 0 0 Map.empty IntMap.empty

-- | Total size of all entries, in the unit of 'insertEntry'.
totalSize :: LruCache k v -> Int
totalSize = size

-- | The value of a key, which becomes the most recently used entry.
lookupEntry :: Ord k => k -> LruCache k v -> Maybe (v, LruCache k v)
lookupEntry wanted r = do
  -- Uses the stored key and not the argument: the stored key may lie off the heap.
  (key, Entry cost age value) <- (`Map.elemAt` entries r) <$> Map.lookupIndex wanted (entries r)
  let now = clock r + 1
  Just
    ( value,
      r
        { clock = now,
          entries = Map.adjust (const (Entry cost now value)) key (entries r),
          order = IntMap.insert now key (IntMap.delete age (order r))
        }
    )

-- | Inserts a value of the given size. Returns the evicted entries, which include the new one when it is too large by itself or its key is
-- present already.
insertEntry :: Ord k => Int -> k -> Int -> v -> LruCache k v -> ([(k, v)], LruCache k v)
insertEntry most question cost answer r
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

-- | Copies bytes to memory that the garbage collector does not manage.
copyOffHeap :: ByteString -> IO ByteString
copyOffHeap bytes = unsafeUseAsCStringLen bytes $ \(from, n) -> do
  copy <- mallocBytes (max 1 n)
  copyBytes copy from n
  unsafePackMallocCStringLen (copy, n)

-- | Frees a copy made by 'copyOffHeap'. It must not be used afterwards.
freeOffHeap :: ByteString -> IO ()
freeOffHeap = unsafeFinalize
