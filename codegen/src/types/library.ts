/// The names of Rosy and the Prelude that programs use, written from LANGUAGE.md §1.
///
/// One declaration a line, as Haskell writes it.

import {readEnvironment} from "./environment.ts"

const controllerTuples = [2, 3, 4, 5, 6, 7, 8, 9].map(n => {
  const letters = "abcdefghi".slice(0, n).split("")
  const all = (cls: string) =>
    `instance (${letters.map(l => `${cls} ${l}`).join(", ")}) => ${cls} (${letters.join(", ")})`
  return ["Sensor", "Command", "Controller", "Default", "Eq", "Ord", "Show"].map(all).join("\n")
})

const text = `
data Bool = False | True
data Ordering = LT | EQ | GT
data Maybe a = Nothing | Just a
data Either a b = Left a | Right b
data Int
data Integer
data Double
data Float
data Char
data Word
data IO a
type String = [Char]
type FilePath = String
type Degrees = Double
type Radians = Double
type Centimeters = Double
type Meters = Double

data BumperSide = LeftBumper | CenterBumper | RightBumper
data ButtonStatus = Released | Pressed
type BumperStatus = ButtonStatus
data Bumper = Bumper {bumperSide :: BumperSide, bumperStatus :: ButtonStatus}
data CliffSide = LeftCliff | CenterCliff | RightCliff
data CliffStatus = Floor | Hole
data Cliff = Cliff {cliffSide :: CliffSide, cliffStatus :: CliffStatus}
data WheelSide = LeftWheel | RightWheel
data WheelStatus = Ground | Air
data Wheel = Wheel {wheelSide :: WheelSide, wheelStatus :: WheelStatus}
data ButtonNumber = Button0 | Button1 | Button2
data Button = Button {buttonNumber :: ButtonNumber, buttonStatus :: ButtonStatus}
data BumperLeft = BumperLeft ButtonStatus
data BumperCenter = BumperCenter ButtonStatus
data BumperRight = BumperRight ButtonStatus
data CliffLeft = CliffLeft CliffStatus
data CliffCenter = CliffCenter CliffStatus
data CliffRight = CliffRight CliffStatus
data WheelLeft = WheelLeft WheelStatus
data WheelRight = WheelRight WheelStatus
data RobotStatus = Offline | Online
data Velocity = Velocity {velocityLinear :: Double, velocityAngular :: Double}
data Position = Position {positionX :: Double, positionY :: Double}
newtype Orientation = Orientation {orientation :: Double}
data Pose = Pose {posePosition :: Position, poseOrientation :: Orientation}
newtype Seconds = Seconds Double
data Clock = Clock Int Int Int Int
data StdGen
data Memory a = Memory a
data Param a = Param a
data Done a = Done a
data Never = Never
data LedColor = Black | Green | Orange | Red
data Led1 = Led1 LedColor
data Led2 = Led2 LedColor
data Sound = OnSound | OffSound | RechargeSound | ButtonSound | ErrorSound | CleaningStartSound | CleaningEndSound
data Say = Say String
data Task a

class Eq a
class Eq a => Ord a
class Show a
class Enum a
class Bounded a
class Num a
class (Num a, Ord a) => Real a
class (Real a, Enum a) => Integral a
class Num a => Fractional a
class Fractional a => Floating a
class (Real a, Fractional a) => RealFrac a
class Semigroup a
class Semigroup a => Monoid a
class Functor f
class Functor f => Applicative f
class Applicative m => Monad m
class Foldable t
class (Functor t, Foldable t) => Traversable t
class Random a
class RandomGen g
class Sensor a
class Command a
class Controller a
class Runnable a
class Default a
class Typeable a
instance Typeable a

${["Bool", "Ordering", "Int", "Integer", "Double", "Float", "Char", "Word", "()"].map(t => `instance Eq ${t}\ninstance Ord ${t}\ninstance Show ${t}\ninstance Default ${t}`).join("\n")}
${["Bool", "Ordering", "Int", "Integer", "Char", "Word", "()", "Double", "Float"].map(t => `instance Enum ${t}`).join("\n")}
${["Bool", "Ordering", "Int", "Char", "Word", "()"].map(t => `instance Bounded ${t}`).join("\n")}
${["Int", "Integer", "Word"].map(t => `instance Num ${t}\ninstance Real ${t}\ninstance Integral ${t}`).join("\n")}
${["Double", "Float", "Orientation", "Seconds"].map(t => `instance Num ${t}\ninstance Real ${t}\ninstance Fractional ${t}\ninstance RealFrac ${t}\ninstance Floating ${t}`).join("\n")}
${["Int", "Integer", "Double", "Float", "Bool", "Char", "Word"].map(t => `instance Random ${t}`).join("\n")}
${["Maybe a", "Either a b", "[a]"].map(t => ["Eq", "Ord", "Show"].map(c => `instance (${[...new Set(t.match(/\b[ab]\b/g))].map(v => `${c} ${v}`).join(", ")}) => ${c} (${t})`).join("\n")).join("\n")}
instance Semigroup [a]
instance Monoid [a]
instance Semigroup Ordering
instance Monoid Ordering
${["[]", "Maybe", "IO", "Task", "Either e"].map(t => `instance Functor (${t})\ninstance Applicative (${t})\ninstance Monad (${t})`).join("\n")}
${["[]", "Maybe", "Either e"].map(t => `instance Foldable (${t})\ninstance Traversable (${t})`).join("\n")}
instance RandomGen StdGen

${["BumperSide", "ButtonStatus", "Bumper", "CliffSide", "CliffStatus", "Cliff", "WheelSide", "WheelStatus", "Wheel", "ButtonNumber", "Button", "BumperLeft", "BumperCenter", "BumperRight", "CliffLeft", "CliffCenter", "CliffRight", "WheelLeft", "WheelRight", "RobotStatus", "Velocity", "Position", "Orientation", "Pose", "Seconds", "Clock", "LedColor", "Led1", "Led2", "Sound", "Say"].map(t => `instance Eq ${t}\ninstance Ord ${t}\ninstance Show ${t}\ninstance Default ${t}`).join("\n")}
${["Memory a", "Param a", "Done a"].map(t => ["Eq", "Ord", "Show"].map(c => `instance ${c} a => ${c} (${t})`).join("\n")).join("\n")}
${["Bumper", "Cliff", "Wheel", "Button", "BumperLeft", "BumperCenter", "BumperRight", "CliffLeft", "CliffCenter", "CliffRight", "WheelLeft", "WheelRight", "RobotStatus", "Velocity", "Position", "Orientation", "Pose", "Seconds", "Clock", "StdGen", "Never", "()"].map(t => `instance Sensor ${t}`).join("\n")}
instance Default a => Sensor (Memory a)
instance Default a => Sensor (Param a)
instance Sensor a => Sensor (Maybe a)
instance (Sensor a, Sensor b) => Sensor (Either a b)
${["Velocity", "Led1", "Led2", "Sound", "Say", "Never", "()"].map(t => `instance Command ${t}`).join("\n")}
instance Command (Memory a)
instance Command (Param a)
instance Command (Done a)
instance Command a => Command (Maybe a)
instance Command a => Command [a]
instance (Command a, Command b) => Command (Either a b)
instance Default a => Default (Maybe a)
instance Default a => Default (Either a b)
instance Default [a]
${controllerTuples.join("\n")}
instance (Sensor a, Controller b) => Controller (a -> b)
instance Controller a => Controller [a]
instance Command a => Controller a
instance Runnable (Task a)
instance Controller a => Runnable a

simulate :: Runnable a => a -> IO ()
task :: (Command init, Controller ctrl, Typeable end) => init -> ctrl -> Task end
once :: Command a => a -> Task ()
say :: String -> Task ()
wait :: Seconds -> Task ()
parallel :: Task a -> Task b -> Task (a, b)
race :: Task a -> Task b -> Task (Either a b)
forever :: Applicative f => f a -> f b
when :: Applicative f => Bool -> f () -> f ()
unless :: Applicative f => Bool -> f () -> f ()
replicateM_ :: Applicative m => Int -> m a -> m ()
replicateM :: Applicative m => Int -> m a -> m [a]
forM_ :: (Foldable t, Monad m) => t a -> (a -> m b) -> m ()
forM :: (Traversable t, Monad m) => t a -> (a -> m b) -> m (t b)
mapM_ :: (Foldable t, Monad m) => (a -> m b) -> t a -> m ()
mapM :: (Traversable t, Monad m) => (a -> m b) -> t a -> m (t b)
sequence_ :: (Foldable t, Monad m) => t (m a) -> m ()
void :: Functor f => f a -> f ()
return :: Monad m => a -> m a
pure :: Applicative f => a -> f a
(>>=) :: Monad m => m a -> (a -> m b) -> m b
(>>) :: Monad m => m a -> m b -> m b
(=<<) :: Monad m => (a -> m b) -> m a -> m b
fmap :: Functor f => (a -> b) -> f a -> f b
(<$>) :: Functor f => (a -> b) -> f a -> f b
(<*>) :: Applicative f => f (a -> b) -> f a -> f b

degreesToOrientation :: Degrees -> Orientation
orientationToDegrees :: Orientation -> Degrees
normOrientation :: Orientation -> Orientation
degreesToRadians :: Degrees -> Radians
radiansToDegrees :: Radians -> Degrees
normRadians :: Radians -> Radians
centimetersToMeters :: Centimeters -> Meters
metersToCentimeters :: Meters -> Centimeters
doubleToSeconds :: Double -> Seconds
positionToVec :: Position -> (Double, Double)
vecToPosition :: (Double, Double) -> Position
addVec :: (Double, Double) -> (Double, Double) -> (Double, Double)
subVec :: (Double, Double) -> (Double, Double) -> (Double, Double)
scalarVec :: Double -> Double -> (Double, Double)
magnitudeVec :: (Double, Double) -> Double
angleVec :: (Double, Double) -> Double
extVec :: (Double, Double) -> Double -> (Double, Double)
random :: (RandomGen g, Random a) => g -> (a, g)
randomR :: (RandomGen g, Random a) => (a, a) -> g -> (a, g)

(+) :: Num a => a -> a -> a
(-) :: Num a => a -> a -> a
(*) :: Num a => a -> a -> a
(/) :: Fractional a => a -> a -> a
(^) :: (Num a, Integral b) => a -> b -> a
(**) :: Floating a => a -> a -> a
(==) :: Eq a => a -> a -> Bool
(/=) :: Eq a => a -> a -> Bool
(<) :: Ord a => a -> a -> Bool
(<=) :: Ord a => a -> a -> Bool
(>) :: Ord a => a -> a -> Bool
(>=) :: Ord a => a -> a -> Bool
(&&) :: Bool -> Bool -> Bool
(||) :: Bool -> Bool -> Bool
(++) :: [a] -> [a] -> [a]
(<>) :: Semigroup a => a -> a -> a
(.) :: (b -> c) -> (a -> b) -> a -> c
($) :: (a -> b) -> a -> b
(!!) :: [a] -> Int -> a
not :: Bool -> Bool
otherwise :: Bool
negate :: Num a => a -> a
abs :: Num a => a -> a
signum :: Num a => a -> a
subtract :: Num a => a -> a -> a
fromIntegral :: (Integral a, Num b) => a -> b
realToFrac :: (Real a, Fractional b) => a -> b
div :: Integral a => a -> a -> a
mod :: Integral a => a -> a -> a
quot :: Integral a => a -> a -> a
rem :: Integral a => a -> a -> a
even :: Integral a => a -> Bool
odd :: Integral a => a -> Bool
round :: (RealFrac a, Integral b) => a -> b
floor :: (RealFrac a, Integral b) => a -> b
ceiling :: (RealFrac a, Integral b) => a -> b
truncate :: (RealFrac a, Integral b) => a -> b
pi :: Floating a => a
sin :: Floating a => a -> a
cos :: Floating a => a -> a
tan :: Floating a => a -> a
atan :: Floating a => a -> a
sqrt :: Floating a => a -> a
exp :: Floating a => a -> a
log :: Floating a => a -> a
min :: Ord a => a -> a -> a
max :: Ord a => a -> a -> a
compare :: Ord a => a -> a -> Ordering
show :: Show a => a -> String
fst :: (a, b) -> a
snd :: (a, b) -> b
id :: a -> a
const :: a -> b -> a
flip :: (a -> b -> c) -> b -> a -> c
map :: (a -> b) -> [a] -> [b]
filter :: (a -> Bool) -> [a] -> [a]
foldr :: Foldable t => (a -> b -> b) -> b -> t a -> b
foldl :: Foldable t => (b -> a -> b) -> b -> t a -> b
zip :: [a] -> [b] -> [(a, b)]
zipWith :: (a -> b -> c) -> [a] -> [b] -> [c]
length :: Foldable t => t a -> Int
null :: Foldable t => t a -> Bool
sum :: (Foldable t, Num a) => t a -> a
product :: (Foldable t, Num a) => t a -> a
maximum :: (Foldable t, Ord a) => t a -> a
minimum :: (Foldable t, Ord a) => t a -> a
elem :: (Foldable t, Eq a) => a -> t a -> Bool
any :: Foldable t => (a -> Bool) -> t a -> Bool
all :: Foldable t => (a -> Bool) -> t a -> Bool
and :: Foldable t => t Bool -> Bool
or :: Foldable t => t Bool -> Bool
concat :: Foldable t => t [a] -> [a]
concatMap :: Foldable t => (a -> [b]) -> t a -> [b]
reverse :: [a] -> [a]
head :: [a] -> a
tail :: [a] -> [a]
take :: Int -> [a] -> [a]
drop :: Int -> [a] -> [a]
replicate :: Int -> a -> [a]
lines :: String -> [String]
unlines :: [String] -> String
words :: String -> [String]
unwords :: [String] -> String
maybe :: b -> (a -> b) -> Maybe a -> b
either :: (a -> c) -> (b -> c) -> Either a b -> c
undefined :: a
error :: [Char] -> a
until :: (a -> Bool) -> (a -> a) -> a -> a
enumFromTo :: Enum a => a -> a -> [a]
fromEnum :: Enum a => a -> Int
toEnum :: Enum a => Int -> a
minBound :: Bounded a => a
maxBound :: Bounded a => a
mempty :: Monoid a => a
mconcat :: Monoid a => [a] -> a
`

export const library = readEnvironment(text)
