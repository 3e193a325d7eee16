{-# LANGUAGE ScopedTypeVariables #-}
{-# LANGUAGE TupleSections #-}

-- |
-- Module      : Patrol
-- Description : A patrol robot, written the way libraries are
-- Maintainer  : nobody@example.org
--
-- The robot visits way points, keeps a log of what it bumped into, and comes
-- home when its imagined battery runs low.
module Patrol
  ( -- * Running
    main
  , patrol
    -- * Geometry
  , Vec (..)
  , (^+^), (*^), dot, norm
    -- * Logs
  , Log, emptyLog, record
  ) where

import           Control.Monad        (forM_, unless, when)
import           Data.List            (foldl', sortBy)
import qualified Data.Map.Strict      as Map
import           Data.Maybe           (fromMaybe, mapMaybe)
import           Data.Ord             (comparing)

------------------------------------------------------------------------------
-- Geometry
------------------------------------------------------------------------------

-- | A vector in the plane, in metres.
data Vec = Vec
  { vecX :: Double  -- ^ to the right
  , vecY :: Double  -- ^ up
  }
  deriving (Eq, Ord, Show)

infixl 6 ^+^, ^-^
infixr 7 *^
infix  7 `dot`

-- | Adds two vectors.
(^+^) :: Vec -> Vec -> Vec
Vec a b ^+^ Vec c d = Vec (a + c) (b + d)

-- | Subtracts two vectors.
(^-^) :: Vec -> Vec -> Vec
Vec a b ^-^ Vec c d = Vec (a - c) (b - d)
{-# INLINE (^-^) #-}

(*^) :: Double -> Vec -> Vec
k *^ Vec a b = Vec (k * a) (k * b)

dot :: Vec -> Vec -> Double
dot (Vec a b) (Vec c d) = a * c + b * d

norm :: Vec -> Double
norm v = sqrt (v `dot` v)

-- | The unit vector, unless there is none.
--
-- >>> normalise (Vec 3 4)
-- Just (Vec 0.6 0.8)
normalise :: Vec -> Maybe Vec
normalise v
  | n > epsilon = Just ((1 / n) *^ v)
  | otherwise   = Nothing
  where
    n       = norm v
    epsilon = 1e-9

centroid :: [Vec] -> Maybe Vec
centroid [] = Nothing
centroid vs = Just $ (1 / fromIntegral (length vs)) *^ foldr (^+^) (Vec 0 0) vs

------------------------------------------------------------------------------
-- Logs
------------------------------------------------------------------------------

-- | What was hit, and how often.
newtype Log = Log { unLog :: Map.Map String Int }

emptyLog :: Log
emptyLog = Log Map.empty

record :: String -> Log -> Log
record what (Log m) = Log $ Map.insertWith (+) what 1 m

mostOften :: Log -> [(String, Int)]
mostOften = take 3 . sortBy (flip (comparing snd)) . Map.toList . unLog

summary :: Log -> String
summary l = unlines [ name ++ ": " ++ show count | (name, count) <- mostOften l, count > 1 ]

total :: Log -> Int
total = foldl' (+) 0 . Map.elems . unLog

------------------------------------------------------------------------------
-- The plan
------------------------------------------------------------------------------

data Mode
  = Driving { target :: Vec, remaining :: [Vec] }
  | Escaping { until' :: Seconds, next :: Mode }
  | Resting

data Config = Config
  { cfgSpeed    :: !Double
  , cfgPatience :: {-# UNPACK #-} !Int
  }

defaultConfig :: Config
defaultConfig = Config { cfgSpeed = 0.25, cfgPatience = 4 }

wayPoints :: [Vec]
wayPoints =
  [ Vec 0 0
  , Vec 1 0
  , Vec 1 1
  , Vec 0 1
  ]

-- | One decision of the robot.
decide :: Config -> Position -> Orientation -> Mode -> (Velocity, Mode)
decide cfg (Position x y) (Orientation heading) mode = case mode of
  Resting -> (Velocity 0 0, Resting)

  Driving { target = t, remaining = rest }
    | distance < 0.05, (r : rs) <- rest -> (Velocity 0 0, Driving r rs)
    | distance < 0.05 -> (Velocity 0 0, Resting)
    | abs turn > 0.3 -> (Velocity 0 (signum turn), mode)
    | otherwise -> (Velocity speed turn, mode)
    where
      here     = Vec x y
      towards  = t ^-^ here
      distance = norm towards
      turn     = normRadians (atan2 (vecY towards) (vecX towards) - heading)
      speed    = min (cfgSpeed cfg) distance

  Escaping { next = n } -> (Velocity (negate (cfgSpeed cfg)) 0, n)

patrol :: Memory Mode -> Position -> Orientation -> (Velocity, Memory Mode)
patrol (Memory mode) p o =
  let (velocity, mode') = decide defaultConfig p o mode
   in (velocity, Memory mode')

bumped :: Bumper -> Seconds -> Memory Mode -> Memory Log -> (Memory Mode, Memory Log, Maybe Say)
bumped (Bumper side Pressed) now (Memory mode) (Memory l) =
  ( Memory Escaping { until' = now + 1, next = mode }
  , Memory l'
  , if total l' > cfgPatience defaultConfig then Just (Say (summary l')) else Nothing
  )
  where
    l' = record (sideName side) l

    sideName :: BumperSide -> String
    sideName LeftBumper   = "left"
    sideName RightBumper  = "right"
    sideName CenterBumper = "centre"
bumped _ _ mode l = (mode, l, Nothing)

-- | Everything that can be decided ahead.
plan :: [Vec] -> Either String (Vec, [Vec])
plan vs = do
  c <- maybe (Left "no way points") Right (centroid vs)
  let far v = norm (v ^-^ c) > 10
      (bad, good) = (filter far vs, filter (not . far) vs)
  unless (null bad) $ Left ("too far: " ++ show bad)
  case good of
    [] -> Left "nothing left"
    (v : rest) -> Right (v, rest)

main :: IO ()
main = simulate (patrol, bumped)
