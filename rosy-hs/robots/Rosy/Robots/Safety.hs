-- |
-- Module      : Rosy.Robots.Safety
-- Description : Safety rules: the robot backs off from obstacles and edges.
--
-- In: events. Out: a velocity that overrides that of the program. The rules and speeds are those of
-- kobuki_safety_controller (safety_controller.hpp: spinOnce): the first that fits wins.
module Rosy.Robots.Safety
  ( Hazards,
    noHazards,
    updateHazards,
    evasiveVelocity,
  )
where

import qualified Data.Set as Set
import Rosy.Channel (Message)
import Rosy.Robot

-- | Pressed bumpers, cliff sensors above a hole, and hanging wheels.
data Hazards = Hazards {pressed :: !(Set.Set BumperSide), over :: !(Set.Set CliffSide), hanging :: !(Set.Set WheelSide)}
  deriving (Eq, Show)

noHazards :: Hazards
noHazards = Hazards Set.empty Set.empty Set.empty

updateHazards :: Message -> Hazards -> Hazards
updateHazards m t = case m of
  BumperMessage (Bumper side s) -> t {pressed = change (s == Pressed) side (pressed t)}
  CliffMessage (Cliff side s) -> t {over = change (s == Hole) side (over t)}
  WheelMessage (Wheel side s) -> t {hanging = change (s == Air) side (hanging t)}
  _ -> t
  where
    change yes = if yes then Set.insert else Set.delete

-- | m/s and rad/s: stand still with a wheel in the air, otherwise back off, away from the side that is in trouble.
-- Left and right together count as left, as there.
evasiveVelocity :: Hazards -> Maybe (Double, Double)
evasiveVelocity t
  | not (Set.null (hanging t)) = Just (0, 0)
  | at CenterBumper CenterCliff = Just (-0.1, 0)
  | at LeftBumper LeftCliff = Just (-0.1, -0.4)
  | at RightBumper RightCliff = Just (-0.1, 0.4)
  | otherwise = Nothing
  where
    at b c = Set.member b (pressed t) || Set.member c (over t)
