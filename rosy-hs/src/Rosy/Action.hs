{-# LANGUAGE AllowAmbiguousTypes #-}
{-# LANGUAGE DeriveGeneric #-}
{-# LANGUAGE FlexibleContexts #-}
{-# LANGUAGE FunctionalDependencies #-}
{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE PatternSynonyms #-}
{-# LANGUAGE ScopedTypeVariables #-}

-- |
-- Module      : Rosy.Action
-- Description : Tasks that a robot's own programs carry out: actions and services of ROS (rule R26).
--
-- > data Count = Count Int
-- > newtype Counting = Counting [Int]
-- > newtype Counted = Counted [Int]
-- >
-- > instance Action Count Counting Counted where
-- >   action = actionServer "/fibonacci" "actionlib_tutorials/Fibonacci" (\(Count n) -> [("order", whole n)]) (Counting <$> field "sequence") (Counted <$> field "sequence")
-- >
-- > main = simulate $ do
-- >   outcome <- callAction (Count 5)
-- >   …
--
-- A call is an ordinary task: its start sends the goal, its controller takes the replies, and its clean-up cancels the goal. A goal and
-- its replies travel on two channels that all links carry. A link that cannot reach a server answers that there is none; no call waits in silence.
module Rosy.Action
  ( -- * An action
    Action (..),
    ActionServer,
    actionServer,
    callAction,
    Outcome (..),

    -- * A service
    Service (..),
    ServiceServer,
    serviceServer,
    callService,

    -- * Actions of the robot
    dock,
    undock,
    driveDistance,
    rotateAngle,
    navigateTo,
  )
where

import Control.Exception (throw)
import Data.Aeson (Value (..), object, (.!=), (.:), (.:?))
import qualified Data.Aeson as Aeson
import Data.Aeson.Types (parseMaybe)
import qualified Data.ByteString.Lazy as Lazy
import Data.Text (Text)
import qualified Data.Text as Text
import GHC.Generics (Generic)
import Rosy.Command
import Rosy.Controller hiding (parts)
import Rosy.Core (Effect (Act), Effects (Then), channelInterest, pattern Plain)
import qualified Rosy.Core as Core
import Rosy.Geometry
import Rosy.Motion (drive, turn)
import Rosy.Outcome
import Rosy.Problem (Fault (Unreadable))
import Rosy.Request (Request (..), callPrefix, replyChannel, replyEnding, requestFrame, shownReply, pattern ReplyMessage, pattern RequestAction)
import Rosy.Robot (Velocity (..))
import Rosy.Sense (event)
import Rosy.Sensor
import Rosy.Task
import Rosy.Topic
import qualified Rosy.Value as Rosy
import System.Random (StdGen, randomR)

-- ---------------------------------------------------------------------------------------------
-- Servers

-- | Where an action is carried out, and how its goal, feedback and result are messages.
data ActionServer goal feedback result = ActionServer Text Text (goal -> [(String, Content)]) (Fields feedback) (Fields result)

-- | The action of this name and type, @package\/Action@, with the fields of a goal, of its feedback and of its result.
actionServer :: String -> String -> (goal -> [(String, Content)]) -> Fields feedback -> Fields result -> ActionServer goal feedback result
actionServer name kind = ActionServer (Text.pack (absolute name)) (Text.pack kind)

-- | Types of goals that a program of the robot pursues. A goal's type decides the types of its feedback and of its result.
class Action goal feedback result | goal -> feedback result where
  -- | Who pursues it.
  action :: ActionServer goal feedback result

-- | Where a service is, and how its request and response are messages.
data ServiceServer request response = ServiceServer Text Text (request -> [(String, Content)]) (Fields response)

-- | The service of this name and type, @package\/Service@, with the fields of a request and of its response.
serviceServer :: String -> String -> (request -> [(String, Content)]) -> Fields response -> ServiceServer request response
serviceServer name kind = ServiceServer (Text.pack (absolute name)) (Text.pack kind)

-- | Types of requests that a service answers. A request's type decides the type of its response.
class Service request response | request -> response where
  -- | Who answers it.
  service :: ServiceServer request response

-- ---------------------------------------------------------------------------------------------
-- Calls

-- | The task that pursues a goal: it gives 'Feedback' while it lasts, and ends with the outcome. When it is stopped the goal is cancelled.
callAction :: forall goal feedback result. (Action goal feedback result, Rosy.Value feedback, Rosy.Value result) => goal -> Task (Outcome result)
callAction = pursue (action :: ActionServer goal feedback result)

pursue :: (Rosy.Value feedback, Rosy.Value result) => ActionServer goal feedback result -> goal -> Task (Outcome result)
pursue (ActionServer name kind content feedback result) goal =
  taskWithNamed (Name "callAction") (Name "callAction") (Name "callAction") taskOptions {starting = begin, stopped = cancel} hear
  where
    begin :: StdGen -> (Sending, Memory CallId)
    begin = sending (\ident -> SendGoal ident name kind (contentValue (record (content goal))))
    cancel (Memory (CallId ident)) = Sending (CancelGoal ident name)
    hear reply (Memory ident)
      | not (reply `answers` ident) = (Nothing, Nothing)
      | otherwise = case ending reply of
        Nothing -> (Just (Feedback (readContent name feedback (replyValues reply))), Nothing)
        Just ended -> (Nothing, Just (Done (readContent name result (replyValues reply) <$ ended)))

-- | The task that calls a service, and ends with the outcome.
callService :: forall request response. (Service request response, Rosy.Value response) => request -> Task (Outcome response)
callService request = taskNamed (Name "callService") (Name "callService") begin hear
  where
    ServiceServer name kind content response = service :: ServiceServer request response
    begin = sending (\ident -> CallService ident name kind (contentValue (record (content request))))
    hear reply (Memory ident)
      | reply `answers` ident = Done . (readContent name response (replyValues reply) <$) <$> ending reply
      | otherwise = Nothing

-- | The identifier of a call.
newtype CallId = CallId Text
  deriving (Eq, Generic)

instance Rosy.Value CallId where
  display d (CallId ident) = Rosy.display d (Text.unpack ident)
  settle budget (CallId ident) = ident `seq` budget - 1
  initial _ = Just (CallId "")

instance Rosy.Default CallId

-- | A request on its way to the link.
newtype Sending = Sending Request

instance Command Sending where
  -- Computed here, so that an error in a goal is blamed on the function that sends it.
  command = Plain (\(Sending request) rest -> let frame = requestFrame request in Lazy.length (Aeson.encode frame) `seq` Then (Act (RequestAction frame)) rest)

sending :: (Text -> Request) -> StdGen -> (Sending, Memory CallId)
sending request gen = (Sending (request ident), Memory (CallId ident))
  where
    ident = callPrefix <> Text.pack (show (fst (randomR (0, 2 ^ (53 :: Int)) gen) :: Int))

-- | What a server says of a request: its frame, whose request it is, the message in it, and how the call ended if it did.
data Reply = Reply {replyFrame :: Value, replyId :: Text, replyValues :: Value, ending :: Maybe (Outcome ())}

instance Rosy.Value Reply where
  display _ reply = showString (shownReply (replyFrame reply))
  settle budget reply = reply `seq` budget - 1
  initial _ = Nothing

instance Sensor Reply where
  sensor = event (channelInterest replyChannel) pick
    where
      pick occurrence = case occurrence of
        Core.Sensed (ReplyMessage frame@(Object o)) -> parseMaybe (parts frame) o
        _ -> Nothing
      parts frame o = Reply frame <$> o .: "id" <*> o .:? "values" .!= object [] <*> pure (replyEnding frame)

answers :: Reply -> CallId -> Bool
answers reply (CallId ident) = replyId reply == ident

readContent :: Text -> Fields a -> Value -> a
readContent name fields = either (throw . Unreadable (Text.unpack name)) id . readFields fields

-- ---------------------------------------------------------------------------------------------
-- Actions of the robot

-- | An action that the robot's description names, which tells its type.
robotAction :: Text -> [(String, Content)] -> Task (Outcome ())
robotAction name content = pursue (ActionServer name "" (const content) (pure ()) (pure ()) :: ActionServer () () ()) ()

-- | Drive into the charging dock, which must be in sight, and stand still.
dock :: Task (Outcome ())
dock = once (Velocity 0 0) >> robotAction "dock" []

-- | Leave the dock. A robot without such an action drives back 30 cm.
undock :: Task (Outcome ())
undock = robotAction "undock" [] `orElse` drive (-30)

-- | Drive so many metres ahead (back if negative), by the robot's own action if it has one, and by 'drive' otherwise.
driveDistance :: Meters -> Task (Outcome ())
driveDistance distance = robotAction "drive_distance" [("distance", decimal distance), ("max_translation_speed", decimal 0.3)] `orElse` drive (metersToCentimeters distance)

-- | Turn by so many degrees (left is positive), by the robot's own action if it has one, and by 'turn' otherwise.
rotateAngle :: Degrees -> Task (Outcome ())
rotateAngle angle = robotAction "rotate_angle" [("angle", decimal (degreesToRadians angle)), ("max_rotation_speed", decimal 1.9)] `orElse` turn angle

-- | Drive to a place round what stands in the way, and stand there facing so many degrees to the left of how the robot stood at the start. The
-- place is in metres, as 'goTo' measures it. It is the action of Nav2, which the simulated robots have as well; nothing drives in its place.
navigateTo :: Meters -> Meters -> Degrees -> Task (Outcome ())
navigateTo ahead left facing = once (Velocity 0 0) >> robotAction "navigate_to" [("pose", record [("header", record [("frame_id", text "odom")]), ("pose", pose)])]
  where
    half = degreesToRadians facing / 2
    pose = record [("position", record [("x", decimal ahead), ("y", decimal left)]), ("orientation", record [("z", decimal (sin half)), ("w", decimal (cos half))])]

orElse :: Task (Outcome ()) -> Task () -> Task (Outcome ())
orElse own substitute =
  own >>= \outcome -> case outcome of
    Unavailable _ -> Succeeded () <$ substitute
    _ -> pure outcome
