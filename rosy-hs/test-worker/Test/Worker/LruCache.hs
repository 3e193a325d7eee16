-- |
-- Module      : Test.Worker.LruCache
-- Description : Properties of the LRU cache: bounded size, and eviction of the least recently used entries.
module Test.Worker.LruCache (tests) where

import Data.List (foldl', sort)
import Rosy.Worker.LruCache
import Test.Tasty (TestTree, testGroup)
import Test.Tasty.QuickCheck

-- | State of a client that looks up keys and inserts missing ones, each with its own size.
data Seen = Seen
  { -- | The youngest first.
    asked :: [Int],
    answered :: Int,
    given :: [Int],
    memory :: LruCache Int Int
  }

most :: Int
most = 20

sizeOf :: Int -> Int
sizeOf question = question `mod` 25

ask :: Seen -> Int -> Seen
ask s question = case lookupEntry question (memory s) of
  Just (_, rest) -> s {asked = question : asked s, memory = rest}
  Nothing ->
    let (gone, rest) = insertEntry most question (sizeOf question) (negate question) (memory s)
     in Seen (question : asked s) (answered s + 1) (map fst gone ++ given s) rest

-- | What a list, the youngest first, says must be there.
expected :: [Int] -> [Int]
expected questions = takeWithin 0 (foldr (\q known -> q : filter (/= q) known) [] (filter ((<= most) . sizeOf) questions))
  where
    takeWithin total (q : qs) | total + sizeOf q <= most = q : takeWithin (total + sizeOf q) qs
    takeWithin _ _ = []

-- | What is there after some questions.
there :: Seen -> [Int]
there end = [q | q <- [0 .. 40], Just (answer, _) <- [lookupEntry q (memory end)], answer == negate q]

tests :: TestTree
tests =
  testGroup
    "remembering"
    [ testProperty "what was asked for last is there, as much as fits" $ \(Questions questions) ->
        let end = after questions
         in there end === sort (expected (asked end)) .&&. totalSize (memory end) === sum (map sizeOf (there end)),
      testProperty "every answer is either there or has been given back once" $ \(Questions questions) ->
        let end = after questions
         in answered end === length (given end) + length (there end)
    ]
  where
    after = foldl' ask (Seen [] 0 [] emptyCache)

newtype Questions = Questions [Int]
  deriving (Show)

instance Arbitrary Questions where
  arbitrary = Questions <$> listOf (choose (0, 40))
  shrink (Questions questions) = Questions <$> shrink questions
