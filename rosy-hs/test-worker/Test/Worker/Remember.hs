-- |
-- Module      : Test.Worker.Remember
-- Description : What is remembered stays within its bound, and what is asked for again stays longest.
module Test.Worker.Remember (tests) where

import Data.List (foldl', sort)
import Rosy.Worker.Remember
import Test.Tasty (TestTree, testGroup)
import Test.Tasty.QuickCheck

-- | Somebody asks; what is not known is answered and remembered, with a size of its own for each question.
data Seen = Seen
  { -- | The youngest first.
    asked :: [Int],
    answered :: Int,
    given :: [Int],
    memory :: Remembered Int Int
  }

most :: Int
most = 20

sizeOf :: Int -> Int
sizeOf question = question `mod` 25

ask :: Seen -> Int -> Seen
ask s question = case recall question (memory s) of
  Just (_, rest) -> s {asked = question : asked s, memory = rest}
  Nothing ->
    let (gone, rest) = remember most question (sizeOf question) (negate question) (memory s)
     in Seen (question : asked s) (answered s + 1) (map fst gone ++ given s) rest

-- | What a list, the youngest first, says must be there.
expected :: [Int] -> [Int]
expected questions = takeWithin 0 (foldr (\q known -> q : filter (/= q) known) [] (filter ((<= most) . sizeOf) questions))
  where
    takeWithin total (q : qs) | total + sizeOf q <= most = q : takeWithin (total + sizeOf q) qs
    takeWithin _ _ = []

-- | What is there after some questions.
there :: Seen -> [Int]
there end = [q | q <- [0 .. 40], Just (answer, _) <- [recall q (memory end)], answer == negate q]

tests :: TestTree
tests =
  testGroup
    "remembering"
    [ testProperty "what was asked for last is there, as much as fits" $ \(Questions questions) ->
        let end = after questions
         in there end === sort (expected (asked end)) .&&. held (memory end) === sum (map sizeOf (there end)),
      testProperty "every answer is either there or has been given back once" $ \(Questions questions) ->
        let end = after questions
         in answered end === length (given end) + length (there end)
    ]
  where
    after = foldl' ask (Seen [] 0 [] nothingYet)

newtype Questions = Questions [Int]
  deriving (Show)

instance Arbitrary Questions where
  arbitrary = Questions <$> listOf (choose (0, 40))
  shrink (Questions questions) = Questions <$> shrink questions
