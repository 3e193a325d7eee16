{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Robots.Target
-- Description : Which robot, how it is reached, and what its topics are called.
--
-- In: @ws://HOST:9090@, @ros://HOST:11311@, @serial:/dev/kobuki@ or @ros2:DOMAIN\@HOST/NAMESPACE@, all of whose parts may be absent, with options
-- behind a question mark. Out: a 'Target', or a sentence. Options: @robot@, @ros=1|2@, @prefix@, @odometry@, @velocity@, @messages@, @stamped=on|off@, @max_speed@,
-- @max_turn@ (m/s, rad/s), @safety=on|off@, @rearm=on|off@, @patience@ (s) and @profile=FILE@, a JSON object with any of these.
-- @bridge@ is not for people: the port of the process that speaks ROS 2.
module Rosy.Robots.Target
  ( Target (..),
    Transport (..),
    Profile (..),
    targetRoutes,
    targetGuard,
    odometryTopic,
    readTarget,
    withFile,
    profileFile,
    TargetError (..),
    explainTargetError,
  )
where

import Control.Monad (foldM)
import Data.Aeson (Value (..))
import qualified Data.Aeson as Aeson
import qualified Data.Aeson.Key as Key
import qualified Data.Aeson.KeyMap as KeyMap
import qualified Data.ByteString as B
import Data.Char (isDigit, isHexDigit)
import Data.Either (fromRight)
import Data.List (find, isPrefixOf, partition, stripPrefix)
import Data.Maybe (fromMaybe, listToMaybe)
import qualified Data.Text as T
import Data.Text.Encoding (encodeUtf8)
import Numeric (readHex)
import Rosy.Codec
import Rosy.Profile
import Rosy.Robot (odometryChannel, velocityChannel)
import Rosy.Robot.Known (robots)
import Rosy.Robots.Guard (Guard, Limits (..), Wheels (..), newGuard, withoutRearming)
import Rosy.Robots.RosbridgeCodec (stampedRoute)
import Rosy.Robots.TextFile (decodeText)
import Rosy.Sentence
import Text.Read (readMaybe)

data Target = Target
  { -- | as it was written
    targetAddress :: String,
    targetTransport :: Transport,
    targetProfile :: Profile,
    targetLimits :: Limits,
    -- | whether the safety rules go before the program
    targetSafety :: Bool,
    -- | how long a lost robot is waited for, seconds
    targetPatience :: Double,
    -- | whether a robot that was lost stands until a person lets it drive again
    targetRearm :: Bool,
    -- | whether the base takes velocities with a time (geometry_msgs/TwistStamped), if the address says so; otherwise it is asked
    targetStamped :: Maybe Bool
  }
  deriving (Eq, Show)

data Transport
  = -- | host, port, path
    Rosbridge String Int String
  | -- | host and port of the master
    Ros1 String Int
  | -- | a device
    Serial FilePath
  | -- | a domain of ROS 2 as it was written, the namespace, and the port of the bridge to it on this computer
    Ros2 String String (Maybe Int)
  deriving (Eq, Show)

-- | A robot, with the variables of its topics and types.
data Profile = Profile
  { profileRobot :: Robot,
    profileVariables :: Variables,
    -- | ROS 2 writes @package/msg/Name@
    isRos2 :: Bool
  }

-- | By name and variables.
instance Eq Profile where
  a == b = (robotName (profileRobot a), profileVariables a, isRos2 a) == (robotName (profileRobot b), profileVariables b, isRos2 b)

instance Show Profile where
  show p = show (robotName (profileRobot p), profileVariables p, isRos2 p)

-- | The channels of the robot with the names that they have there.
targetRoutes :: Target -> [Route]
targetRoutes t = [stamped (if isRos2 p then r {routeType = T.replace (T.pack "/") (kindOf r) (routeType r)} else r) | r <- routes (profileRobot p) (profileVariables p)]
  where
    stamped r = if targetStamped t == Just True && routeChannel r == velocityChannel then stampedRoute r else r
    p = targetProfile t
    kindOf r = T.pack (if routeDelivery r == Called then "/srv/" else "/msg/")

-- | The guard of a run on it.
targetGuard :: Target -> Guard
targetGuard t = (if targetRearm t then id else withoutRearming) (newGuard (targetLimits t) (targetSafety t))

-- | Where odometry comes from.
odometryTopic :: [Route] -> String
odometryTopic known = maybe "" (T.unpack . routeTopic) (routeFor known odometryChannel)

data TargetError
  = -- | Not one of the four.
    StrangeTarget String
  | -- | No robot has this name.
    UnknownRobot String
  | -- | The robot of this name is not reached in this way.
    NoSuchWay String Sentence
  | StrangeOption String
  | -- | An option's value: name, value.
    StrangeValue String String
  | -- | A profile that is no JSON object.
    StrangeProfile FilePath
  deriving (Eq, Show)

explainTargetError :: TargetError -> Sentence
explainTargetError e = case e of
  StrangeTarget t -> trWith "\"{address}\" is no robot. A robot is ws://HOST:9090, ros://HOST:11311, serial:/dev/kobuki or ros2:DOMAIN." ["address" =: T.pack t]
  UnknownRobot n -> trWith "There is no robot called \"{name}\". There are {robots}." ["name" =: T.pack n, "robots" =: T.pack (unwords (map robotName robots))]
  NoSuchWay name way -> trWith "A {name} cannot be reached over {way}. It is behind a rosbridge server: ws://HOST:9090?robot={name}." ["name" =: T.pack name, "way" =@ way]
  StrangeOption o -> trWith "A robot has no option \"{option}\". There are {options}." ["option" =: T.pack o, "options" =: T.unwords known]
  StrangeValue o v -> trWith "\"{value}\" does not fit the option {option}." ["value" =: T.pack v, "option" =: T.pack o]
  StrangeProfile f -> trWith "The profile {file} cannot be read. It is a JSON object of options, such as {example}." ["file" =: T.pack f, "example" =: "{\"prefix\": \"/robot1\"}"]
  where
    known = ["robot", "ros", "prefix", "odometry", "velocity", "messages", "stamped", "max_speed", "max_turn", "safety", "rearm", "patience", "scanner", "pen", "line", "profile"]

-- | The profile that is named there, if one is: its options come before those of the address.
profileFile :: String -> Maybe FilePath
profileFile = lookup "profile" . optionsOf

readTarget :: String -> Either TargetError Target
readTarget = withFile Nothing

-- | With the content of the profile that 'profileFile' names.
withFile :: Maybe B.ByteString -> String -> Either TargetError Target
withFile profile t = do
  way <- maybe (Left (StrangeTarget t)) Right (readWay (takeWhile (/= '?') t))
  let named = optionsOf t
      first = named ++ maybe [] (fromRight [] . fromJson "") profile ++ ofWay way
      robot = lookup "robot" first
  chosen <- maybe (maybe (Left (UnknownRobot "")) Right (listToMaybe robots)) (\n -> maybe (Left (UnknownRobot n)) Right (find ((== n) . robotName) robots)) robot
  mapM_ (Left . NoSuchWay (robotName chosen)) (missingWay way chosen)
  fromProfile <- maybe (Right []) (fromJson (fromMaybe "" (lookup "profile" named))) profile
  let (speed, turn) = robotLimits chosen
      begun = Target t way (startProfile chosen (lookup "ros" first)) (Limits speed turn (uncurry Wheels <$> robotWheels chosen)) True 10 True Nothing
  foldM option begun (prefixFirst (ofWay way ++ fromProfile ++ filter ((/= "profile") . fst) named))
  where
    -- What an address says without options.
    ofWay way = case way of
      Ros2 _ namespace _ -> ("ros", "2") : [("prefix", namespace) | not (null namespace)]
      _ -> []
    -- It moves the topics that are not named.
    prefixFirst = uncurry (++) . partition ((== "prefix") . fst)
    -- Which ROS it is decides where the other options start from, wherever it is written. Without it the robot's first one counts.
    startProfile chosen version = Profile chosen (fromMaybe [] (lookup name (robotProfiles chosen))) (name == "ros2")
      where
        name = maybe (maybe "ros1" fst (listToMaybe (robotProfiles chosen))) (("ros" ++) . takeWhile (/= '.')) version
    missingWay way chosen = case way of
      Ros1 _ _ | "ros1" `notElem` map fst (robotProfiles chosen) -> Just (verbatim "ROS 1")
      Serial _ | null (robotSerial chosen) -> Just (tr "a serial cable")
      Ros2 {} | "ros2" `notElem` map fst (robotProfiles chosen) -> Just (verbatim "ROS 2")
      _ -> Nothing

fromJson :: FilePath -> B.ByteString -> Either TargetError [(String, String)]
fromJson file bytes = case decodeText bytes >>= Aeson.decodeStrict' . encodeUtf8 of
  Just (Object o) -> traverse plain (KeyMap.toList o)
  _ -> Left (StrangeProfile file)
  where
    plain (k, v) =
      (,) (Key.toString k) <$> case v of
        String s -> Right (T.unpack s)
        Number n -> Right (show (realToFrac n :: Double))
        Bool b -> Right (if b then "on" else "off")
        _ -> Left (StrangeProfile file)

option :: Target -> (String, String) -> Either TargetError Target
option t (k, v) = case k of
  "ros"
    | ("ros" ++ takeWhile (/= '.') v) `elem` map fst (robotProfiles (profileRobot p)) -> Right t
    | otherwise -> bad
  "robot" -> Right t
  -- A topic that is defined below the prefix follows it; a TurtleBot's odometry does not.
  "prefix" -> Right t {targetProfile = p {profileVariables = set k v (profileVariables p)}}
  "odometry" -> topic
  "velocity" -> topic
  "messages" -> if null v then bad else Right t {targetProfile = p {profileVariables = set k v (profileVariables p)}}
  "stamped"
    | Serial _ <- targetTransport t -> bad
    | otherwise -> switch (\yes -> t {targetStamped = Just yes})
  "max_speed" -> number (\x -> t {targetLimits = (targetLimits t) {maxSpeed = x}})
  "max_turn" -> number (\x -> t {targetLimits = (targetLimits t) {maxTurn = x}})
  "patience" -> number (\x -> t {targetPatience = x})
  "safety" -> switch (\yes -> t {targetSafety = yes})
  "rearm" -> switch (\yes -> t {targetRearm = yes})
  -- Whether it carries a part that a bought one does not have: the service asks before it starts a program.
  _ | k `elem` ["scanner", "pen", "line"] -> switch (const t)
  "bridge" | Ros2 domain namespace _ <- targetTransport t -> maybe bad (\port -> Right t {targetTransport = Ros2 domain namespace (Just port)}) (readMaybe v)
  _ -> Left (StrangeOption k)
  where
    p = targetProfile t
    bad = Left (StrangeValue k v)
    topic = if "/" `isPrefixOf` v then Right t {targetProfile = p {profileVariables = set k v (profileVariables p)}} else bad
    set name value = map (\(n, old) -> (n, if n == name then value else old))
    switch f = case v of
      "on" -> Right (f True)
      "off" -> Right (f False)
      _ -> bad
    number f = case readMaybe (if take 1 v == "." then '0' : v else v) of
      Just x | x >= 0, not (isInfinite x) -> Right (f x)
      _ -> bad

readWay :: String -> Maybe Transport
readWay t
  | Just rest <- stripPrefix "ws://" t = hostPort 9090 rest >>= \(h, p, path) -> Just (Rosbridge h p (if null path then "/" else path))
  | Just rest <- stripPrefix "ros://" t = hostPort 11311 rest >>= \(h, p, path) -> if path `elem` ["", "/"] then Just (Ros1 h p) else Nothing
  | Just device@('/' : _) <- stripPrefix "serial:" t = Just (Serial device)
  | Just rest <- stripPrefix "ros2:" t = ros2 rest
  | otherwise = Nothing
  where
    -- The domains that fit into the ports of UDP (DDSI-RTPS 2.5, 9.6.2.3) are up to 232.
    ros2 rest
      | null domain || (all isDigit domain && length domain < 4 && read domain < (233 :: Int)), host /= "@", namespace /= "/" = Just (Ros2 (domain ++ host) namespace Nothing)
      | otherwise = Nothing
      where
        (domain, more) = break (`elem` ("@/" :: String)) rest
        (host, namespace) = break (== '/') more
    hostPort fallback rest = case break (`elem` (":/" :: String)) rest of
      ("", _) -> Nothing
      (h, ':' : more) -> case span isDigit more of
        (d@(_ : _), path) | length d < 6, read d < (65536 :: Int), null path || "/" `isPrefixOf` path -> Just (h, read d, path)
        _ -> Nothing
      (h, path) -> Just (h, fallback, path)

-- | What stands behind the question mark.
optionsOf :: String -> [(String, String)]
optionsOf t = [(unescape k, unescape (drop 1 v)) | part <- pieces (drop 1 (dropWhile (/= '?') t)), not (null part), let (k, v) = break (== '=') part]
  where
    pieces s = case break (== '&') s of
      (a, _ : rest) -> a : pieces rest
      (a, []) -> [a]
    unescape s = case s of
      '%' : a : b : rest | isHexDigit a, isHexDigit b, [(n, "")] <- readHex [a, b] -> toEnum n : unescape rest
      c : rest -> c : unescape rest
      [] -> []
