{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE FlexibleContexts #-}
{-# LANGUAGE ScopedTypeVariables #-}

-- |
-- Module      : Test.Rosy.Laws
-- Description : What holds for every program: the monad laws, atomic firing, no event lost, the same twice, bounded space.
module Test.Rosy.Laws (tests) where

import Control.Exception (evaluate)
import Data.Word (Word64)
import GHC.Stats
import Rosy
import Rosy.Loop
import Rosy.Program (Names (..))
import Rosy.Robot
import Rosy.Runnable (program)
import Support.Story
import System.Mem (performMajorGC)
import Test.QuickCheck hiding (collect, once)
import Test.Tasty (TestTree, testGroup)
import Test.Tasty.HUnit
import Test.Tasty.QuickCheck (testProperty)

{- HLINT ignore "Use >=>" -}
{- HLINT ignore "Use <&>" -}

-- | With the number of instants after which memory is compared.
tests :: Int -> TestTree
tests instants =
  testGroup
    "Laws"
    [ testGroup
        "Task is a monad"
        [ testProperty "pure x >>= f is f x" $ \n days -> same days (pure n >>= step) (step n),
          testProperty "m >>= pure is m" $ \n days -> same days (step n >>= pure) (step n),
          testProperty "(m >>= f) >>= g is m >>= (f >>= g)" $ \n days -> same days ((step n >>= step) >>= step) (step n >>= (\x -> step x >>= step)),
          testProperty "fmap f is >>= pure . f" $ \n days -> same days (fmap (+ 1) (step n)) (step n >>= pure . (+ 1))
        ],
      testProperty "firing is atomic: two memories that change together are never seen apart" $ \(Story days) ->
        let apart = commandsOf (both, \() -> compared, \(Bumper _ _) -> compared) days
            compared :: Memory Int -> Memory [()] -> Maybe Say
            compared (Memory a) (Memory b) = if a == length b then Nothing else Just (Say "apart")
            both :: Either Bumper Button -> Memory Int -> Memory [()] -> (Memory Int, Memory [()])
            both _ (Memory a) (Memory b) = (Memory (a + 1), Memory (() : b))
         in apart === [],
      testProperty "no event is lost: every bump is heard once, whatever else the function reads" $ \(Story days) ->
        let bumps = length [() | (_, Hear (BumperMessage _)) <- days]
            heard :: Runnable c => c -> Int
            heard c = length (commandsOf c days)
            odometry = not (null [() | (_, Hear (OdometryMessage _)) <- days])
         in [ heard (\(Bumper _ _) -> Say "x"),
              heard (\(Bumper _ _) (Memory (_ :: Int)) (_ :: Seconds) (_ :: StdGen) -> Say "x"),
              heard (\(Velocity _ _) (Bumper _ _) -> Say "x"),
              heard (\(e :: Either Bumper Button) -> either (const (Just (Say "x"))) (const Nothing) e),
              heard (\(m :: Maybe Bumper) -> Say "x" <$ m),
              heard (\(BumperLeft _) -> Say "x") + heard (\(BumperCenter _) -> Say "x") + heard (\(BumperRight _) -> Say "x")
            ]
              === [bumps, bumps, if odometry then bumps else 0, bumps, bumps, bumps],
      testProperty "the same program twice gives the same run" $ \(Story days) ->
        hear busy days === hear busy days,
      testProperty "a trace so far does not depend on what comes later" $ \(Story days) (NonNegative n) ->
        let early = hear busy (take n days) in take (length early) (hear busy days) === early,
      testCase "an error in what is written is blamed on the function that wrote it" $
        map
          (concatMap heardFired)
          [ simple (\() -> Memory (errorWithoutStackTrace "oh" :: Int)),
            simple (\() -> Param (errorWithoutStackTrace "oh" :: Int)),
            simple (\() -> Memory (1 :: Int, errorWithoutStackTrace "oh" :: Int))
          ]
          @?= replicate 3 ["function 1", "failed: oh"],
      testCaseInfo (show instants ++ " instants of a busy controller run in constant space") $ do
        sizes <- liveSizes (div instants 5) 5
        let growth = fromIntegral (last sizes) - fromIntegral (head sizes) :: Integer
        -- A word that is kept in every thirtieth instant exceeds it; counters and the first uses of each function stay below 10 kB.
        assertBool ("it grows: live bytes after each fifth are " ++ show sizes) (growth < 40000)
        pure ("peak " ++ show (div (maximum sizes) 1000) ++ " kB, growth " ++ show growth ++ " bytes")
    ]
  where
    simple :: Runnable (c, Velocity -> Say) => c -> [Heard]
    simple c = hear (c, \(Velocity _ _) -> Say "read") [at 0 ticked, at 0.02 still]
    same (Story days) a b = hear (a >>= say . show) days === hear (b >>= say . show) days
    -- A task that waits, speaks and ends with a value.
    step :: Int -> Task Int
    step n = task (Say (show n)) (\(Bumper side _) -> Done (n + fromEnum side))

-- | Many kinds of functions at once.
busy :: (Velocity -> Memory Int -> (Memory Int, Maybe Say), Bumper -> StdGen -> Memory Int, Either Button Velocity -> Seconds -> Memory (Double, Int) -> (Memory (Double, Int), Led1))
busy = (\(Velocity _ _) (Memory n) -> (Memory (n + 1), if n `mod` 10 == 0 then Just (Say (show n)) else Nothing), \(Bumper _ _) g -> Memory (fst (randomR (0, 9) g)), \_ (Seconds s) (Memory (_, n)) -> (Memory (s, n + 1), Led1 Green))

-- | Still more at once: memory that is never read, a partner that never comes, events of the program's own, tasks without end,
-- beside each other, on call and cancelled, that all drive without ever standing still.
busier :: Task ()
busier = void (parallel (task () (busy, unread, alone, calling, driving) :: Task ()) (forever (race (walk 3) (wait 0.5))))
  where
    unread :: Velocity -> Memory Integer -> (Memory Integer, Param [Int])
    unread (Velocity v _) (Memory n) = (Memory (n + 1), Param (replicate 5 (round v)))
    alone :: Velocity -> Either Bumper RobotStatus -> Wheel -> Memory (Maybe Int)
    alone _ _ _ = Memory (Just 1)
    calling :: Bumper -> Call
    calling _ = call (walk 2 >> task () (Feedback 'x', \(Button _ _) -> Done ())) callOptions {onFeedback = \c -> Memory (c :: Char), cancelOn = \(Bumper _ _) -> Just Cancel}
    walk :: Int -> Task Int
    walk 0 = pure 0
    walk n = wait 0.04 >> task () (driving, \(Velocity _ _) (Memory k) -> (Memory (k + 1), if k > (1 :: Int) then Just (Done ()) else Nothing)) >> walk (n - 1)
    driving :: Velocity -> Velocity
    driving (Velocity v w) = Velocity (v + 1) w

-- | Bytes that are live after each of so many stretches of so many instants, forgetting all reports.
liveSizes :: Int -> Int -> IO [Word64]
liveSizes stretch = go 0 (begin (Start 0 0 (mkStdGen 1)) (program (Names []) busier))
  where
    go :: Int -> Turn -> Int -> IO [Word64]
    go !_ _ 0 = pure []
    go !k next left = case next of
      Fires firing after -> evaluate (firingEffects firing) >> go k after left
      Settled network
        | k > 0 && k `mod` stretch == 0 -> do
          performMajorGC
          size <- gcdetails_live_bytes . gc <$> getRTSStats
          (size :) <$> step k network (left - 1)
        | otherwise -> step k network left
      Enters _ _ after -> go k after left
      Closes _ after -> go k after left
      Ended _ -> assertFailure "it ended"
    step k network = go (k + 1) (instant (0.02 * fromIntegral k) (what k) (snd (collect network)))
    what k
      | k `mod` 7 == 0 = Hear (BumperMessage (Bumper LeftBumper Pressed))
      | k `mod` 11 == 0 = TickNow
      | otherwise = moving (fromIntegral (k `mod` 5))

newtype Story = Story [Moment]
  deriving (Show)

instance Arbitrary Story where
  arbitrary = do
    n <- choose (0, 20)
    kinds <- vectorOf n (elements [0 .. 5 :: Int])
    sides <- vectorOf n arbitraryBoundedEnum
    pure (Story (zipWith3 moment [0 :: Int ..] kinds sides))
    where
      moment i kind side = at (0.02 * fromIntegral i) $ case kind of
        0 -> sensed (BumperMessage (Bumper side Pressed))
        1 -> sensed (BumperMessage (Bumper side Released))
        2 -> sensed (ButtonMessage (Button Button1 Pressed))
        3 -> ticked
        _ -> moving (fromIntegral i)
  shrink (Story days) = Story <$> shrinkList (const []) days
