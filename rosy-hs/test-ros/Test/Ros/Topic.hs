-- |
-- Description : Topics mean what lists mean.
module Test.Ros.Topic (tests) where

import Control.Concurrent.Async (concurrently, withAsync)
import Control.Concurrent.MVar
import Control.Concurrent.STM (atomically)
import Control.Exception (ErrorCall (..), throwIO, try)
import Control.Monad.Trans.Class (lift)
import Control.Monad.Trans.Reader (asks)
import qualified Control.Monad.Trans.State.Lazy as Lazy
import qualified Control.Monad.Trans.State.Strict as Strict
import Data.Bifunctor (second)
import Data.Functor.Identity (Identity (..))
import Data.IORef
import Data.List (mapAccumL, sort)
import Data.Maybe (catMaybes)
import Ros.Queue
import Ros.Topic (Topic (..))
import qualified Ros.Topic as T
import Ros.Topic.PID
import Ros.Topic.Transformers
import Ros.Topic.Util
import qualified Ros.Util.PID as Single
import Test.Tasty
import Test.Tasty.HUnit
import Test.Tasty.QuickCheck

tests :: TestTree
tests = testGroup "topics" [pureOnes, transformed, controllers, singleControllers, joined, shared, queues]

-- | The values 0, 1, 2, …; and the first ten of what a function makes of them.
numbers :: Topic Identity Int
numbers = T.iterate (+ 1) 0

ten :: Topic Identity a -> [a]
ten = runIdentity . T.take 10

pureOnes :: TestTree
pureOnes =
  testGroup
    "are lists without an end"
    [ law "fmap" (fmap (* 3)) (map (* 3)),
      law "<*>" (\t -> (,) <$> t <*> T.tail t) (\xs -> zip xs (tail xs)),
      law "filter" (T.filter even) (filter even),
      law "scan" (T.scan (+) 5) (tail . scanl (+) 5),
      law "drop" (T.drop 4) (drop 4),
      law "dropWhile" (T.dropWhile (< 7)) (dropWhile (< 7)),
      law "consecutive" consecutive (\xs -> zip xs (tail xs)),
      law "slidingWindow" (slidingWindow 3 . fmap pure) (\xs -> [take 3 (drop i xs) | i <- [0 ..]]),
      law "slidingWindowG" (slidingWindowG 3) (\xs -> [sum (take 3 (drop i xs)) | i <- [0 ..]]),
      law "subsample" (subsample 3) (\xs -> [xs !! i | i <- [3, 7 ..]]),
      law "topicOn" (topicOn (`div` 2) (,) (pure (pure . (* 10)))) (map (\x -> (x, x `div` 2 * 10))),
      law "concats" (concats . fmap (\x -> replicate (x `mod` 3) x)) (concatMap (\x -> replicate (x `mod` 3) x)),
      law "catMaybes" (T.catMaybes . fmap (\x -> if odd x then Just x else Nothing)) (filter odd),
      law "finiteDifference" (finiteDifference subtract . fmap (^ (2 :: Int))) (\xs -> zipWith (-) (tail (map (^ (2 :: Int)) xs)) (map (^ (2 :: Int)) xs)),
      law "cons" (T.cons 9) (9 :),
      law "mapAccum" (T.mapAccum (\s x -> (s + x, x)) 0) (\xs -> zipWith (+) (0 : xs) xs),
      law "metamorph" (T.metamorph everyOther) (\xs -> [xs !! i | i <- [0, 2 ..]]),
      law "metamorphM" (T.metamorphM (Identity . effectful . everyOther)) (\xs -> [xs !! i | i <- [0, 2 ..]]),
      law "bimetamorph" (T.bimetamorph everyOther (each (* 2))) (concatMap (\x -> [x | even x] ++ [x * 2])),
      law "bimetamorphE" (T.bimetamorphE everyOther (each show)) (concatMap (\x -> [Left x | even x] ++ [Right (show x)])),
      law "bimetamorphME" (T.bimetamorphME (Identity . effectful . everyOther) (Identity . effectful . each show)) (concatMap (\x -> [Left x | even x] ++ [Right (show x)])),
      law "repeatM and join" (T.join . fmap pure) id,
      law "unfold" (const (T.unfold (\n -> Identity (n * n, n + 1)) 0)) (map (^ (2 :: Int))),
      testCase "force waits for the first value and keeps it" $ ten (runIdentity (T.force numbers)) @?= [0 .. 9],
      law "gate" (\t -> gate t (T.repeat ())) id,
      law "filterBy" (filterBy (T.repeat even)) (filter even),
      testCase "break stops before the value and keeps it" $
        second ten (runIdentity (T.break (> 3) numbers)) @?= ([0 .. 3], [4 .. 13]),
      testCase "takeWhile" $ runIdentity (T.takeWhile (< 4) numbers) @?= [0 .. 3],
      testCase "tails start at each value" $ map T.head (ten (T.tails numbers)) @?= map Identity [0 .. 9],
      testCase "a running mean forgets with its weight" $
        take 3 (ten (weightedMean 0.5 (+) (*) (fmap fromIntegral numbers) :: Topic Identity Double)) @?= [0.5, 1.25, 2.125],
      testCase "a running mean of whole numbers" $
        take 4 (ten (weightedMeanNormalized 1 1 (+) (*) (`div` 2) numbers)) @?= [0, 1, 2, 3],
      testCase "differences of neighbours are older to newer" $
        take 3 (ten (finiteDifference (,) numbers)) @?= [(0, 1), (1, 2), (2, 3)],
      testCase "Simpson's rule is exact for squares" $
        take 2 (ten (simpsonsRule (+) (*) (fmap (\n -> fromIntegral n * fromIntegral n) numbers) :: Topic Identity Rational)) @?= [8 / 3, 26 / 3],
      testCase "each predicate takes its first value" $
        take 3 (ten (filterBy (fromList [even, odd, (> 7)]) (T.drop 1 numbers))) @?= [2, 3, 8],
      testCase "a topic as a list is pulled when it is looked at" $ do
        pulled <- newIORef (0 :: Int)
        xs <- toList (T.repeatM (atomicModifyIORef' pulled (\n -> (n + 1, n))))
        readIORef pulled >>= (@?= 0)
        take 3 xs @?= [0, 1, 2]
        readIORef pulled >>= (@?= 3),
      testCase "a list ends in its last value" $ ten (fromList "abc") @?= "abcccccccc"
    ]
  where
    everyOther x = T.yield x (\_ -> T.skip everyOther)
    each f x = T.yield (f x) (each f)
    effectful (T.IterCont (y, next)) = T.IterContM (y, Identity . effectful . next)
    law :: (Eq b, Show b) => String -> (Topic Identity Int -> Topic Identity b) -> ([Int] -> [b]) -> TestTree
    law name onTopic onList = testCase name $ ten (onTopic numbers) @?= take 10 (onList [0 ..])

transformed :: TestTree
transformed =
  testGroup
    "with a state or an environment"
    [ testCase "a lazy state goes from value to value" $ ten (runTopicState (T.repeatM (Lazy.state (\n -> (n, n * 2)))) 1) @?= take 10 (iterate (* 2) 1),
      testCase "so does a strict one" $ ten (runTopicState' (T.repeatM (Strict.state (\n -> (n, n * 2)))) 1) @?= take 10 (iterate (* 2) 1),
      testProperty "liftMap changes each value where its topic has no such effects" $ \(r :: Int) ->
        ten (runTopicReader (liftMap (\x -> asks (+ x)) numbers) r) === map (+ r) [0 .. 9],
      testCase "liftMap pulls one value for each action" $
        ten (runTopicState' (liftMap (\x -> Strict.modify (+ x) >> Strict.get) numbers) 0) @?= tail (scanl (+) 0 [0 .. 9]),
      testCase "an action below the state runs once for each value" $ do
        pulled <- newIORef (0 :: Int)
        _ <- T.take 3 (runTopicState' (T.repeatM (lift (modifyIORef pulled (+ 1)))) ())
        readIORef pulled >>= (@?= 3)
    ]

-- | Rational numbers, so that sums and quotients are exact.
singleControllers :: TestTree
singleControllers =
  testGroup
    "PID controllers of single values"
    [ testProperty "the proportional part has the sign of value minus setpoint" $ \kp setpoint e1 e2 (x :: Rational) ->
        Single.pidUniform kp 0 0 setpoint e1 e2 x === (x - setpoint, kp * (x - setpoint)),
      testProperty "the integral of errors on a parabola is exact" $ \a b c (Positive dt) ->
        let e t = a * t * t + b * t + c :: Rational
            area t = a * t * t * t / 3 + b * t * t / 2 + c * t
         in snd (Single.pidFixed 0 1 0 0 dt (e 0) (e dt) (e (2 * dt))) === area (2 * dt),
      testProperty "the derivative of a ramp is its slope" $ \kd slope start (Positive dt) ->
        snd (Single.pidFixed 0 0 kd 0 dt start (start + slope * dt) (start + 2 * slope * dt)) === kd * slope * (1 :: Rational),
      testProperty "with times one apart it is the uniform one" $ \kp ki kd setpoint t e1 e2 (x :: Rational) ->
        Single.pidTimed kp ki kd setpoint (t, e1) (t + 1, e2) (t + 2, x) === Single.pidUniform kp ki kd setpoint e1 e2 x,
      testProperty "one that remembers begins with two zeros, and then gives a step of the last two errors" $ \kp ki kd setpoint (xs :: [Rational]) -> ioProperty $ do
        control <- Single.pidUniformIO kp ki kd
        signals <- mapM (control setpoint) xs
        let errors = map (subtract setpoint) xs
            steps = zipWith3 (\e1 e2 x -> snd (Single.pidUniform kp ki kd setpoint e1 e2 x)) errors (drop 1 errors) (drop 2 xs)
        pure (signals === take (length xs) (0 : 0 : steps)),
      testProperty "so does one whose values have times" $ \kp ki kd setpoint (xs :: [Rational]) -> ioProperty $ do
        timed <- Single.pidWithTimeIO kp ki kd
        uniform <- Single.pidUniformIO kp ki kd
        (===) <$> mapM (timed setpoint) (zip [7 ..] xs) <*> mapM (uniform setpoint) xs,
      testProperty "values that come at one time give no infinite signal" $ \kp ki kd setpoint t (xs :: [Double]) -> ioProperty $ do
        control <- Single.pidWithTimeIO kp ki kd
        signals <- mapM (\x -> control setpoint (t, x)) xs
        pure (property (not (any (\s -> isNaN s || isInfinite s) signals)))
    ]

-- | Rational numbers, so that sums and quotients are exact.
controllers :: TestTree
controllers =
  testGroup
    "PID controllers"
    [ testProperty "the first signal is proportional" $ \kp ki kd setpoint x -> first 1 (pidUniform kp ki kd setpoint (T.repeat x)) === [kp * (setpoint - x)],
      testProperty "a constant error is summed over time" $ \ki dt' e -> let dt = abs dt' + 1 in first 10 (pidFixed 0 ki 0 e dt (T.repeat 0)) === [ki * e * dt * n | n <- [0 .. 9]],
      testProperty "a ramp has its slope" $ \kd slope dt' ->
        let dt = abs dt' + 1
         in drop 1 (first 10 (pidFixed 0 0 kd 0 dt (T.iterate (+ slope * dt) 0))) === replicate 9 (negate (kd * slope)),
      testProperty "a fixed distance is that of the stamps" $ \kp ki kd setpoint dt' xs ->
        let dt = abs dt' + 1
            values = fromList (0 : xs)
         in first 20 (pidFixed kp ki kd setpoint dt values) === first 20 (pidStamped kp ki kd setpoint (T.mapAccum (\t x -> ((t, x), t + dt)) 7 values)),
      testProperty "the signal is linear in the error" $ \kp ki kd k xs ->
        let values = 0 : xs
            out factor = first 20 (pidUniform kp ki kd 0 (fromList (map (* factor) values)))
         in out k === map (* k) (out 1),
      testCase "a value that is no newer does not divide by zero" $ first 3 (pidStamped 1 1 1 0 (fromList [(1, 2), (1, 4), (2, 4)])) @?= [-2, -4, -8],
      testProperty "a process that sums its signals comes to its setpoint" $ \setpoint ->
        let path = iterate (\x -> x + last (first 1 (pidUniform (1 / 2) 0 0 setpoint (T.repeat x)))) 0 in abs (path !! 40 - setpoint) <= abs setpoint / 1000000,
      testProperty "leftThenRight: the newest left and the first right after it" $ \(xs :: [Either Int Char]) ->
        let pairs (Left a : Right b : rest) = (a, b) : pairs rest
            pairs (_ : rest) = pairs rest
            pairs [] = []
         in runIdentity (T.take (length (pairs xs)) (leftThenRight (fromList (xs ++ [Left 0, Right 'x'])))) === pairs xs
    ]
  where
    first :: Int -> Topic Identity Rational -> [Rational]
    first n = runIdentity . T.take n

joined :: TestTree
joined =
  testGroup
    "join"
    [ testProperty "bothNew: the later side decides, the earlier gives its newest, both are used once" $ \(xs :: [Either Int Char]) ->
        run stepBothNew neitherNew xs === bothNewModel xs,
      testProperty "everyNew: every value, with the other's newest" $ \(xs :: [Either Int Char]) ->
        run stepEveryNew noneYet xs === everyNewModel xs,
      testCase "merge drops nothing and keeps each side's order" $ do
        xs <- T.take 2000 (merge (finite [0, 2 .. 1998]) (finite [1, 3 .. 1999]))
        sort xs @?= [0 .. 1999 :: Int]
        filter even xs @?= [0, 2 .. 1998],
      testCase "a failing source fails its puller" $ do
        r <- try (T.take 5 (merge (T.repeatM (throwIO (ErrorCall "sensor"))) (T.repeatM (newEmptyMVar >>= takeMVar))))
        either (\(ErrorCall e) -> e) (show :: [()] -> String) r @?= "sensor",
      testCase "a source without rhythm is not pulled far ahead of its reader" $ do
        pulled <- newIORef (0 :: Int)
        let source = T.repeatM (atomicModifyIORef' pulled (\n -> (n + 1, n)))
        _ <- T.take 3 (merge source source)
        n <- readIORef pulled
        assertBool (show n) (n < 100)
    ]
  where
    run step s = catMaybes . snd . mapAccumL (\st x -> let (y, st') = step st x in (st', y)) s
    -- Gives its values, then waits for ever.
    finite :: [a] -> Topic IO a
    finite = foldr (\x t -> Topic (pure (x, t))) (Topic (newEmptyMVar >>= takeMVar))

bothNewModel :: [Either a b] -> [(a, b)]
bothNewModel xs = case break isRight xs of
  ([], _ : _) -> case span isRight xs of
    (rs, Left x : rest) -> (x, right (last rs)) : bothNewModel rest
    _ -> []
  (ls, Right y : rest) -> (left (last ls), y) : bothNewModel rest
  _ -> []
  where
    isRight = either (const False) (const True)
    right = either (error "a left among the rights") id
    left = either id (error "a right among the lefts")

everyNewModel :: [Either a b] -> [(a, b)]
everyNewModel xs =
  [ (a, b)
    | n <- [1 .. length xs],
      let before = take n xs,
      Just a <- [newest [x | Left x <- before]],
      Just b <- [newest [y | Right y <- before]]
  ]
  where
    newest ys = if null ys then Nothing else Just (last ys)

shared :: TestTree
shared =
  testGroup
    "share"
    [ testProperty "tee: both readers see everything, whichever is faster, and effects happen once" $ \(order :: [Bool]) -> ioProperty $ do
        pulled <- newIORef (0 :: Int)
        (a, b) <- tee (T.repeatM (atomicModifyIORef' pulled (\n -> (n + 1, n))))
        (xs, ys) <- inTurn order a b
        n <- readIORef pulled
        pure (conjoin [xs === take (length xs) [0 ..], ys === take (length ys) [0 ..], n === max (length xs) (length ys)]),
      testCase "fan: readers in threads of their own see the same" $ do
        source <- newIORef (0 :: Int)
        readers <- fan 2 (T.repeatM (atomicModifyIORef' source (\n -> (n + 1, n))))
        case readers of
          [a, b] -> concurrently (T.take 500 a) (T.take 500 b) >>= (@?= ([0 .. 499], [0 .. 499]))
          _ -> assertFailure "two readers were asked for",
      testCase "teeEager: both readers see everything, and it is pulled without being read" $ do
        pulled <- newEmptyMVar
        (a, b) <- teeEager (T.repeatM (takeMVar pulled))
        mapM_ (putMVar pulled) [0 .. 9 :: Int]
        (,) <$> T.take 10 b <*> T.take 10 a >>= (@?= ([0 .. 9], [0 .. 9])),
      testCase "forkTopic: a source in a thread of its own, in order" $ do
        source <- newIORef (0 :: Int)
        t <- forkTopic (T.repeatM (atomicModifyIORef' source (\n -> (n + 1, n))))
        T.take 100 t >>= (@?= [0 .. 99]),
      testCase "interruptible: a new list takes the place of what is left" $ do
        lists <- newEmptyMVar
        out <- newEmptyMVar
        withAsync (T.mapM_ (putMVar out) (interruptible (T.repeatM (takeMVar lists)))) $ \_ -> do
          putMVar lists (Just 'a')
          takeMVar out >>= (@?= 'a')
          putMVar lists (Just 'b')
          takeMVar out >>= (@?= 'b'),
      testCase "share: a late reader begins where the topic stands" $ do
        source <- newIORef (0 :: Int)
        t <- share (T.repeatM (atomicModifyIORef' source (\n -> (n + 1, n))))
        first <- T.take 3 t
        later <- T.take 3 t
        (first, later) @?= ([0, 1, 2], [3, 4, 5]),
      testCase "partition gives each value to one side" $ do
        source <- newIORef (0 :: Int)
        (evens, odds) <- partition even (T.repeatM (atomicModifyIORef' source (\n -> (n + 1, n))))
        (,) <$> T.take 3 evens <*> T.take 3 odds >>= (@?= ([0, 2, 4], [1, 3, 5])),
      testCase "a rate limit gives the first value at once and loses none" $
        T.take 3 (topicRate 1000 (fromList [1 :: Int, 2, 3])) >>= (@?= [1, 2, 3]),
      testCase "newestOn: the newest value at each tick" $ do
        ticks <- newEmptyMVar
        values <- newEmptyMVar
        let t = newestOn (T.repeatM (takeMVar values)) (T.repeatM (takeMVar ticks))
        out <- newEmptyMVar
        withAsync (T.mapM_ (putMVar out) t) $ \_ -> do
          putMVar values 'a'
          putMVar values 'b' -- taken, so 'a' is in the queue
          putMVar values 'c' -- so is 'b'
          putMVar ticks (1 :: Int)
          (x, n) <- takeMVar out
          assertBool [x] (x `elem` "bc" && n == 1)
    ]
  where
    inTurn = go [] []
    go xs ys order a b = case order of
      [] -> pure (reverse xs, reverse ys)
      True : rest -> runTopic a >>= \(x, a') -> go (x : xs) ys rest a' b
      False : rest -> runTopic b >>= \(y, b') -> go xs (y : ys) rest a b'

queues :: TestTree
queues =
  testGroup
    "queues"
    [ testProperty "a full queue keeps the newest, in order, and counts the others" $ \(Positive bound) (xs :: [Int]) -> ioProperty $ do
        q <- newQueue bound
        mapM_ (atomically . push q) xs
        lost <- atomically (missed q)
        kept <- if null xs then pure [] else atomically (popAll q)
        let n = min bound (length xs)
        pure (conjoin [kept === drop (length xs - n) xs, lost === length xs - n])
    ]
