-- |
-- Module      : Rosy.Geometry
-- Description : Angles, lengths and vectors.
--
-- Plain arithmetic in plain numbers; the type names say which unit is meant.
module Rosy.Geometry
  ( -- * Units
    Degrees,
    Radians,
    Centimeters,
    Meters,
    degreesToRadians,
    radiansToDegrees,
    normRadians,
    centimetersToMeters,
    metersToCentimeters,
    doubleToSeconds,
    secondsToDouble,

    -- * Orientations
    degreesToOrientation,
    orientationToDegrees,
    normOrientation,

    -- * Vectors
    Vec,
    positionToVec,
    vecToPosition,
    scalarVec,
    magnitudeVec,
    angleVec,
    addVec,
    subVec,
    extVec,
    DPoint,
    DVector,
    DLine,
    DCircle,
    negVec,
    mulVec,
    divVec,
    normVec,
    sumVec,
    averageVec,
    distVec,
    dotProdVec,
    crossProdVec,
    circleLineIntersection,
  )
where

import Rosy.Robot
import Rosy.Time

-- | An angle of which 360 go round.
type Degrees = Double

-- | An angle of which 2π go round.
type Radians = Double

-- | A length of which 100 are a metre.
type Centimeters = Double

-- | A length in metres.
type Meters = Double

-- | >>> degreesToRadians 180
-- 3.141592653589793
degreesToRadians :: Degrees -> Radians
degreesToRadians d = d * pi / 180

-- | >>> radiansToDegrees pi
-- 180.0
radiansToDegrees :: Radians -> Degrees
radiansToDegrees r = r * 180 / pi

-- | The same direction as an angle above -π and up to π.
--
-- >>> normRadians (3 * pi)
-- 3.141592653589793
normRadians :: Radians -> Radians
normRadians r
  | r > negate pi && r <= pi = r
  | otherwise =
    let turned = r - 2 * pi * fromIntegral (ceiling ((r - pi) / (2 * pi)) :: Integer)
     in if turned <= negate pi then pi else min pi turned

-- | >>> centimetersToMeters 32
-- 0.32
centimetersToMeters :: Centimeters -> Meters
centimetersToMeters = (/ 100)

-- | >>> metersToCentimeters 0.5
-- 50.0
metersToCentimeters :: Meters -> Centimeters
metersToCentimeters = (* 100)

-- | A number of seconds as a time.
doubleToSeconds :: Double -> Seconds
doubleToSeconds = Seconds

-- | A time as a number of seconds.
secondsToDouble :: Seconds -> Double
secondsToDouble (Seconds s) = s

-- | A heading of so many degrees, counter-clockwise.
degreesToOrientation :: Degrees -> Orientation
degreesToOrientation = Orientation . degreesToRadians

-- | A heading in degrees.
orientationToDegrees :: Orientation -> Degrees
orientationToDegrees (Orientation r) = radiansToDegrees r

-- | The same heading as an angle above -π and up to π.
normOrientation :: Orientation -> Orientation
normOrientation (Orientation r) = Orientation (normRadians r)

-- | A way to go: metres along x, metres along y.
type Vec = (Double, Double)

-- | The way from the start to a position.
positionToVec :: Position -> Vec
positionToVec (Position x y) = (x, y)

-- | The position at the end of a way from the start.
vecToPosition :: Vec -> Position
vecToPosition (x, y) = Position x y

-- | The vector of a length and an angle (radians).
scalarVec :: Double -> Radians -> Vec
scalarVec size angle = (size * cos angle, size * sin angle)

-- | The length of a vector.
magnitudeVec :: Vec -> Double
magnitudeVec (x, y) = sqrt (x * x + y * y)

-- | The angle of a vector, radians.
angleVec :: Vec -> Radians
angleVec (x, y) = atan2 y x

-- | One way after the other.
addVec :: Vec -> Vec -> Vec
addVec (x, y) (x', y') = (x + x', y + y')

-- | The first without the second: the way from the second to the first.
subVec :: Vec -> Vec -> Vec
subVec (x, y) (x', y') = (x - x', y - y')

-- | A vector in the same direction, so much longer.
extVec :: Vec -> Double -> Vec
extVec v more = scalarVec (magnitudeVec v + more) (angleVec v)

-- | A place on the plane, metres. The name of 2019.
type DPoint = Vec

-- | A vector. The name of 2019.
type DVector = Vec

-- | The straight line through two places. The name of 2021.
type DLine = (DPoint, DPoint)

-- | A circle: its centre and its radius in metres. The name of 2021.
type DCircle = (DPoint, Meters)

-- | The opposite vector.
negVec :: Vec -> Vec
negVec (x, y) = (negate x, negate y)

-- | A vector times a number.
mulVec :: Double -> Vec -> Vec
mulVec k (x, y) = (k * x, k * y)

-- | A vector divided by a number.
divVec :: Vec -> Double -> Vec
divVec (x, y) k = (x / k, y / k)

-- | The vector of length 1 at an angle (radians).
normVec :: Radians -> Vec
normVec = scalarVec 1

-- | The sum of all vectors.
sumVec :: [Vec] -> Vec
sumVec = foldr addVec (0, 0)

-- | The mean of all vectors; (0, 0) of none.
averageVec :: [Vec] -> Vec
averageVec [] = (0, 0)
averageVec vs = sumVec vs `divVec` fromIntegral (length vs)

-- | The distance between two places.
distVec :: Vec -> Vec -> Double
distVec a b = magnitudeVec (subVec a b)

-- | The dot product: the product of the lengths and the cosine of the angle between.
dotProdVec :: Vec -> Vec -> Double
dotProdVec (x, y) (x', y') = x * x' + y * y'

-- | The cross product: the product of the lengths and the sine of the angle from the first to the second, negative to the right.
crossProdVec :: Vec -> Vec -> Double
crossProdVec (x, y) (x', y') = x * y' - y * x'

-- | The places where a circle meets a line: two, one if they touch, or none. The first is the one further along from the line's first
-- place to its second. None if both places of the line are the same.
--
-- >>> circleLineIntersection ((0, 0), 1) ((-2, 0), (2, 0))
-- [(1.0,0.0),(-1.0,0.0)]
circleLineIntersection :: DCircle -> DLine -> [DPoint]
circleLineIntersection (centre, radius) (from, to)
  | way == (0, 0) || room < 0 = []
  | room == 0 = [at nearest]
  | otherwise = map at [nearest + reach, nearest - reach]
  where
    way = subVec to from
    size = dotProdVec way way
    -- In lengths of the way: the place of the line that is nearest to the centre, and half of the chord.
    nearest = dotProdVec (subVec centre from) way / size
    room = radius * radius * size - crossProdVec way (subVec centre from) ^ (2 :: Int)
    reach = sqrt room / size
    at share = addVec from (mulVec share way)
