{-# LANGUAGE FlexibleInstances #-}
{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE PatternSynonyms #-}
{-# LANGUAGE ViewPatterns #-}

-- |
-- Module      : Rosy.Topic
-- Description : Sensors and commands of the program's own: a type connected to a topic and the fields of its messages (rule R23).
--
-- > newtype Charge = Charge Double
-- >
-- > instance Sensor Charge where
-- >   sensor = topic "/battery_state" "sensor_msgs/BatteryState" (Charge <$> field "percentage")
-- >
-- > data Buzz = Buzz
-- >
-- > instance Command Buzz where
-- >   command = publish "/buzzer" "std_msgs/UInt8" (\\Buzz -> [("data", whole 3)])
--
-- All links carry these messages on two channels, one for each direction, as the topic and the message in its JSON form. Here is
-- data only: which topics the link may use is for the link to say.
module Rosy.Topic
  ( -- * A sensor
    topic,
    Fields,
    field,
    FieldType (..),

    -- * A command
    publish,
    typeNamed,
    Content,
    whole,
    decimal,
    truth,
    text,
    list,
    record,

    -- * For links
    pattern OpenMessage,
    pattern OpenAction,
    sensorTopics,
    commandTopics,
    absolute,
    readFields,
    contentValue,
  )
where

import Control.Exception (throw)
import Data.Aeson (Value (..))
import qualified Data.Aeson as Aeson
import qualified Data.Aeson.Key as Key
import qualified Data.Aeson.KeyMap as KeyMap
import qualified Data.ByteString as ByteString
import qualified Data.ByteString.Base64 as Base64
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (toList)
import Data.Maybe (maybeToList)
import Data.Scientific (floatingOrInteger, fromFloatDigits)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import qualified Data.Vector as Vector
import Rosy.Channel (Action (..), Channel (..), Field (Structure), Kind (..), Message (..))
import qualified Rosy.Channel as Channel
import Rosy.Core (Effect (Act), Effects (Then), Plan (..), Sense (..), Topic (..), TopicUse (..), channelInterest, channelLimit, replyChannelNumber)
import qualified Rosy.Core as Core
import Rosy.JsonNumber (doubleIn)
import Rosy.Problem (Fault (NotANumber, Unreadable))
import Rosy.Sense (convert, event)
import qualified Rosy.Value as Rosy

-- ---------------------------------------------------------------------------------------------
-- Channels

-- | The messages of topics that the program takes.
openSensor :: Channel
openSensor = Channel channelLimit "Topic" EventChannel 0 Nothing shownMessage

-- | The messages of topics that the program sends, as values of a type of the program with this name.
openCommand :: String -> Channel
openCommand kind = Channel (replyChannelNumber + 1) kind CommandChannel 0 Nothing shownMessage

shownMessage :: [Field] -> Maybe String
shownMessage fields = case fields of
  [Channel.Text name, Structure message] -> Just (name ++ " " ++ Text.unpack (Text.decodeUtf8 (Lazy.toStrict (Aeson.encode message))))
  _ -> Nothing

-- | A message on a topic of the program's own.
pattern OpenMessage :: String -> Value -> Message
pattern OpenMessage name message <-
  Message ((== openSensor) -> True) [Channel.Text name, Structure message]
  where
    OpenMessage name message = Message openSensor [Channel.Text name, Structure message]

-- | A command on a topic of the program's own.
pattern OpenAction :: String -> Value -> Action
pattern OpenAction name message <-
  Action ((== openCommand "") -> True) [Channel.Text name, Structure message]
  where
    OpenAction name message = Action (openCommand "Topic") [Channel.Text name, Structure message]

-- | The topic of a sensor.
sensorTopics :: Sense a -> [Topic]
sensorTopics = maybeToList . senseTopic

-- | The topic of a command.
commandTopics :: Plan c -> [Topic]
commandTopics plan = case plan of
  Producing found _ -> maybeToList found
  Needing _ _ -> []

-- | A topic with its slash. ROS resolves a name without one against the node's namespace, which is @\/@ here.
absolute :: String -> String
absolute name = if take 1 name == "/" then name else '/' : name

-- ---------------------------------------------------------------------------------------------
-- Sensors

-- | The messages of a topic, by its name and type, as a value of the program: each triggers, like a bumper. A message whose fields do not fit ends the
-- run with a sentence that names the field.
topic :: Rosy.Value a => String -> String -> Fields a -> Sense a
topic name kind (Fields look) = connected (convert opened Message' (event (channelInterest openSensor) pick))
  where
    connected s = s {senseTopic = Just (Topic (absolute name) kind Taken)}
    pick occurrence = case occurrence of
      Core.Sensed (OpenMessage from message) | from == absolute name -> Just (Message' (either (throw . Unreadable (absolute name)) id (look message)))
      _ -> Nothing

{- HLINT ignore Message' "Use newtype instead of data" -}

-- | A value that is computed by the function that takes it, so that the function is named when a field is missing. Its field is lazy.
data Message' a = Message' {opened :: a}

instance Rosy.Value a => Rosy.Value (Message' a) where
  display d (Message' x) = Rosy.display d x
  settle budget (Message' x) = Rosy.settle budget x
  initial pending = Message' <$> Rosy.initial pending

-- | What is read from the fields of a message. Combined with @\<$\>@ and @\<*\>@.
newtype Fields a = Fields (Value -> Either String a)

instance Functor Fields where
  fmap f (Fields look) = Fields (fmap f . look)

instance Applicative Fields where
  pure x = Fields (const (Right x))
  Fields f <*> Fields x = Fields (\message -> f message <*> x message)

-- | What the fields of a message say, or the field that is missing or of another kind.
readFields :: Fields a -> Value -> Either String a
readFields (Fields look) = look

-- | A field by its name; inside of others with dots: @field "pose.pose.position.x"@.
field :: FieldType a => String -> Fields a
field path = Fields (go (Text.splitOn "." (Text.pack path)))
  where
    go :: FieldType a => [Text.Text] -> Value -> Either String a
    go names message = case (names, message) of
      ([], _) -> maybe (Left path) Right (fromMessage message)
      (name : rest, Object o) | Just inner <- KeyMap.lookup (Key.fromText name) o -> go rest inner
      _ -> Left path

-- | The types that a field may have: 'Int', 'Double', 'Bool', text, and lists of them.
class FieldType a where
  fromMessage :: Value -> Maybe a

instance FieldType Int where
  fromMessage v = case v of
    Number n | Right i <- (floatingOrInteger n :: Either Double Integer), abs i < 2 ^ (53 :: Int) -> Just (fromInteger i)
    _ -> Nothing

instance FieldType Double where
  fromMessage = doubleIn

-- | Some senders write 0 and 1.
instance FieldType Bool where
  fromMessage v = case v of
    Bool b -> Just b
    Number 0 -> Just False
    Number 1 -> Just True
    _ -> Nothing

instance {-# OVERLAPPING #-} FieldType [Char] where
  fromMessage v = case v of
    String t -> Just (Text.unpack t)
    _ -> Nothing

-- | An array of bytes may be a text in base 64, as rosbridge servers write it.
instance FieldType a => FieldType [a] where
  fromMessage v = case v of
    Array a -> mapM fromMessage (toList a)
    String t | Right bytes <- Base64.decode (Text.encodeUtf8 t) -> mapM (fromMessage . Number . fromIntegral) (ByteString.unpack bytes)
    _ -> Nothing

-- ---------------------------------------------------------------------------------------------
-- Commands

-- | A value of the program as a message on a topic, by the topic's name and type and the message's fields. Fields that are not given are zero.
publish :: String -> String -> (c -> [(String, Content)]) -> Plan c
publish name kind make = Producing (Just (Topic (absolute name) kind Sent)) send
  where
    send c = case record (make c) of
      Content message -> evaluated message `seq` Then (Act (OpenAction (absolute name) message))
    evaluated message = case message of
      Object o -> foldr (seq . evaluated) () o
      Array a -> foldr (seq . evaluated) () a
      other -> other `seq` ()

-- | A command on a topic is told by the name of its type, which only the program's text has. Other commands stay as they are.
typeNamed :: String -> Plan c -> Plan c
typeNamed kind plan = case plan of
  Producing connected@(Just _) give -> Producing connected (\c rest -> named (give c rest))
  _ -> plan
  where
    named effects = case effects of
      Then (Act (Action c fields)) rest | c == openCommand "" -> Then (Act (Action (openCommand kind) fields)) rest
      _ -> effects

-- | The content of a field.
newtype Content = Content Value
  deriving (Eq, Show)

-- | The content as JSON.
contentValue :: Content -> Value
contentValue (Content value) = value

-- | A whole number.
whole :: Int -> Content
whole = Content . Number . fromIntegral

-- | A number with a fraction.
decimal :: Double -> Content
decimal x
  | isNaN x || isInfinite x = throw (NotANumber "a field")
  | otherwise = Content (Number (fromFloatDigits x))

-- | True or false.
truth :: Bool -> Content
truth = Content . Bool

-- | Text, of at most 10000 characters.
text :: String -> Content
text = Content . String . Text.pack . take longest

-- | An array, of at most 10000 elements.
list :: [Content] -> Content
list contents = Content (Array (Vector.fromList [v | Content v <- take longest contents]))

-- | Fields inside of a field.
record :: [(String, Content)] -> Content
record contents = Content (Object (KeyMap.fromList [(Key.fromString name, v) | (name, Content v) <- contents]))

-- | A choice of ours, so that an endless text or list ends.
longest :: Int
longest = 10000
