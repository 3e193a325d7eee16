-- |
-- Description : Topics that join by their stamps, against a model over whole lists.
module Test.Ros.Stamped (tests) where

import Control.Concurrent.MVar
import Control.Concurrent.STM
import Control.Exception (ErrorCall (..), throwIO, try)
import Data.Bifunctor (bimap)
import Data.List (nub, sort)
import Ros.Header
import Ros.Message (def)
import Ros.Std_msgs.Header (Header (..))
import Ros.Topic (Topic (..))
import qualified Ros.Topic as T
import Ros.Topic.Stamped
import Test.Tasty
import Test.Tasty.HUnit
import Test.Tasty.QuickCheck hiding (sample)

-- | A message with a stamp in nanoseconds and a number that tells it from others.
data Sample = Sample {sampleHeader :: Header, number :: Int}
  deriving (Eq, Show)

instance Ord Sample where
  compare a b = compare (at a, number a) (at b, number b)

instance HasHeader Sample where
  headerOf f m = (\h -> m {sampleHeader = h}) <$> f (sampleHeader m)

at :: Sample -> Int
at = (\(s, n) -> fromIntegral s * 1000000000 + fromIntegral n) . stampOf

sample :: Int -> Int -> Sample
sample n time = Sample def {_stamp = (fromIntegral (time `div` 1000000000), fromIntegral (time `mod` 1000000000))} n

-- | Two topics with growing stamps around a full second, and an order in which their values arrive.
newtype Arrivals = Arrivals [Either Sample Sample]
  deriving (Show)

instance Arbitrary Arrivals where
  arbitrary = do
    order <- listOf arbitrary
    let growing count = zipWith sample [0 ..] . scanl (+) 999999990 <$> vectorOf count (choose (0, 6))
    ls <- growing (length order)
    rs <- growing (length order)
    pure (Arrivals (deal order ls rs))
    where
      deal (True : rest) (l : ls) rs = Left l : deal rest ls rs
      deal (False : rest) ls (r : rs) = Right r : deal rest ls rs
      deal _ _ _ = []

-- | The neighbours in the list between which this value is, and the value.
bracketed :: [Sample] -> [Sample] -> [(Sample, Sample, Sample)]
bracketed xs ys = [(x1, x2, y) | y <- ys, (x1, x2) <- zip xs (drop 1 xs), at x1 <= at y, at y < at x2]

tests :: TestTree
tests =
  testGroup
    "topics by their stamps"
    [ testProperty "everyNew: each value with the nearest of the other, a mutual pair once, whatever arrives first" $ \(Arrivals arrivals) ->
        let (ls, rs) = sides arrivals
            near (a, b, c) = if at c - at a < at b - at c then a else b
            model = nub ([(near t, y) | t@(_, _, y) <- bracketed ls rs] ++ [(x, near t) | t@(_, _, x) <- bracketed rs ls])
         in sort (run stepEveryNew noneYet arrivals) === sort model,
      testProperty "brackets: every value between two of the other, in order, whatever arrives first" $ \(Arrivals arrivals) ->
        run (stepBrackets stampOf stampOf) noBracket arrivals === uncurry bracketed (sides arrivals),
      testCase "interpolate: a quarter of the way between two" $ do
        let position = fmap (uncurry sample)
            blend a b f = sample (round (fromIntegral (number a) + f * fromIntegral (number b - number a))) 0
        got <- T.take 2 (interpolate blend (finite (position [(0, 1000), (100, 2000), (300, 4000)])) (finite (position [(1, 900), (2, 1250), (3, 3000)])))
        map (bimap number number) got @?= [(25, 2), (200, 3)],
      testCase "everyNew of two topics that run side by side" $ do
        got <- T.take 3 (everyNew (finite (map (sample 0) [0, 10, 20])) (finite (map (sample 1) [1, 12, 30])))
        sort (map (bimap at at) got) @?= [(0, 1), (10, 12), (20, 12)],
      testCase "a clock that is set back starts again, on either side" $ do
        let lefts = map (Left . sample 0)
            rights = map (Right . sample 1)
            pairs = map (\(a, b, y) -> (at a, at b, at y)) . run (stepBrackets stampOf stampOf) noBracket
        pairs (lefts [100, 110] ++ rights [105] ++ lefts [5, 15] ++ rights [6, 16] ++ lefts [25]) @?= [(100, 110, 105), (5, 15, 6), (15, 25, 16)]
        pairs (lefts [100, 110] ++ rights [105, 6] ++ lefts [5, 15] ++ rights [7] ++ lefts [25]) @?= [(100, 110, 105), (5, 15, 7)],
      testCase "of a topic whose partner is silent the newest thousand wait" $ do
        let early = map (Right . sample 1) [1 .. 5000]
        map (\(_, _, y) -> at y) (run (stepBrackets stampOf stampOf) noBracket (early ++ map (Left . sample 0) [0, 6000])) @?= [4001 .. 5000],
      testCase "batch: what comes until the window closes is one list" $ do
        closed <- newTVarIO False
        -- The pull of the fourth value closes the window and gives no value.
        let pull n = if n == 4 then atomically (writeTVar closed True) >> newEmptyMVar >>= takeMVar else pure (n, n + 1)
        T.take 1 (batchUntil (pure (readTVar closed >>= check)) (T.unfold pull (1 :: Int))) >>= (@?= [[1, 2, 3]]),
      testCase "batch: nothing is lost or empty, and a failing source fails its puller" $ do
        batches <- T.take 20 (batch 0 (T.iterate (+ 1) (0 :: Int)))
        assertBool (show batches) (not (any null batches))
        concat batches @?= take (length (concat batches)) [0 ..]
        r <- try (T.take 1 (batch 3600 (T.cons 'a' (T.repeatM (throwIO (ErrorCall "sensor"))))))
        either (\(ErrorCall e) -> e) (show :: [String] -> String) r @?= "sensor"
    ]
  where
    sides arrivals = ([x | Left x <- arrivals], [y | Right y <- arrivals])
    run _ _ [] = []
    run step now (x : xs) = let (out, later) = step now x in out ++ run step later xs
    finite :: [a] -> Topic IO a
    finite = foldr (\x t -> Topic (pure (x, t))) (Topic (newEmptyMVar >>= takeMVar))
