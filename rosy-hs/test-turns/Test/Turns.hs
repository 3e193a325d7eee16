-- |
-- Module      : Test.Turns
-- Description : Turns of long tests: @./rosy test@ runs a share that changes daily, @./rosy test nightly@ all of them.
--
-- Tests of the main path of each part take no turns and run daily. All tests run while a source file of their part has changed since the last run that
-- passed, and when they are started by hand, without a daily seed.
module Test.Turns (Day, today, nextDays, rotated) where

import Data.List (isPrefixOf)
import System.Environment (lookupEnv)

-- | What decides which tests are run.
data Day
  = -- | All tests.
    Every
  | -- | Those of the day with this seed.
    Seed Int

-- | As @scripts/test.py@ says, for tests of the sources in these folders.
today :: [FilePath] -> IO Day
today folders = do
  share <- lookupEnv "ROSY_TEST_SHARE"
  seed <- lookupEnv "ROSY_TEST_SEED"
  changed <- maybe [] lines <$> lookupEnv "ROSY_TEST_CHANGED"
  let isChanged = or [folder `isPrefixOf` file | folder <- folders, file <- changed]
  pure (if share == Just "1" || isChanged then Every else maybe Every (Seed . read) seed)

-- | Every @parts@-th: the next ones with the next seed, so that each has its turn.
rotated :: Day -> Int -> [a] -> [a]
rotated Every _ xs = xs
rotated (Seed seed) parts xs = [x | (i, x) <- zip [0 ..] xs, (i + seed) `mod` parts == 0]

-- | The day so many days later.
nextDays :: Int -> Day -> Day
nextDays _ Every = Every
nextDays days (Seed seed) = Seed (seed + days)
