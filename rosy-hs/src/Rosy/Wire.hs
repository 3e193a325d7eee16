{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE PatternSynonyms #-}

-- |
-- Module      : Rosy.Wire
-- Description : The robot link in JSON: lines to messages, commands to lines.
--
-- Pure. The lines are those of @protocol/README.md@ section 2, and the golden conversations in @protocol/goldens/link@
-- hold both directions. Integers leave without a decimal point, because real rosbridge servers refuse @1.0@ for one.
module Rosy.Wire
  ( -- * What arrives
    Line (..),
    readLine,
    readLineTaking,
    pipeRoutes,

    -- * What leaves
    Telling (..),
    writeOpening,
    writeAnswer,
    writeEnding,
    branchText,

    -- * Steps
    ticksEvery,
    quietSteps,
  )
where

import Data.Aeson (Object, Value (Object), (.!=), (.:), (.:?))
import qualified Data.Aeson as Aeson
import qualified Data.Aeson.Encoding as Encoding
import Data.Aeson.Types (Parser, parseEither)
import Data.ByteString (ByteString)
import Data.ByteString.Builder (Builder)
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Builder.Extra as Builder
import qualified Data.ByteString.Builder.Prim as Prim
import qualified Data.ByteString.Lazy as Lazy
import Data.Either (fromRight)
import qualified Data.IntMap.Strict as IntMap
import Data.List (find, intersperse)
import Data.Maybe (fromMaybe, isJust)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.BranchCoverage (Branch, TakenBranch (..))
import Rosy.Channel (Action (..), Channel (..), Field (Number), Kind (..), Message (..), tellAction)
import Rosy.Codec
import Rosy.Core (Interest, Topic (..), TopicUse (..), channelInterest, clockInterest, interestedIn, nameText, tickInterest, unite)
import Rosy.Link
import Rosy.Loop.Quiescence (Quiescence (..))
import Rosy.Problem
import Rosy.Profile (Leaf (ANumber), Mapping (..), Place (..), Robot (..), Step (Key))
import Rosy.Provenance
import Rosy.Request (isReply, pattern ReplyMessage, pattern RequestAction)
import Rosy.Robot.Known (simulated)
import Rosy.Sentence (english, sentenceId)
import Rosy.Topic (absolute, pattern OpenAction, pattern OpenMessage)
import Rosy.Wire.NumberTemplate

-- ---------------------------------------------------------------------------------------------
-- What arrives

-- | A line from the simulator.
data Line
  = -- | Protocol version, seed, time of day at the start (s), trace, and whether quiet steps are left out.
    StartLine Int Int Double Bool Bool
  | SensorLine [Message]
  | -- | Number and time (s) of the step whose messages came before, whether the memory is looked at, whether the firings are, and whether
    -- the step was quiet and is over.
    StepLine Int Double Bool Bool Bool
  | StopLine
  deriving (Eq, Show)

-- | What a line says, or why it says nothing.
readLine :: ByteString -> Either String Line
readLine = readLineTaking []

-- | 'readLine' for a program that takes these topics itself.
readLineTaking :: [String] -> ByteString -> Either String Line
readLineTaking taken bytes
  | null taken, Just known <- frequentLine bytes = Right known
  | otherwise = case Aeson.decodeStrict' bytes of
    Just (Object o) -> parseEither (line taken) o
    _ -> Left "not a JSON object"

-- | The lines of which there is one in each step, read by templates; they mean what they mean as JSON.
frequentLine :: ByteString -> Maybe Line
frequentLine bytes = foldr (\(form, said) others -> case numbersIn form bytes >>= said of Nothing -> others; found -> found) Nothing frequentForms

-- | Forms of lines, and what their numbers say.
frequentForms :: [(NumberTemplate, [Double] -> Maybe Line)]
frequentForms = [clock | route <- sensorRoutes pipeRoutes, channelKind (routeChannel route) == ClockChannel, Just clock <- [clockForm route]] ++ [stepForm looks watches late | (looks, watches, late) <- [(False, False, False), (False, True, False), (False, False, True), (True, False, False), (True, True, False)]]

-- | The form of the messages of a channel, if their numbers are in the order of its places.
clockForm :: Route -> Maybe (NumberTemplate, [Double] -> Maybe Line)
clockForm route = case (numbersIn form example >>= said, Aeson.decodeStrict' example) of
  (Just found, Just (Object o)) | parseEither (line []) o == Right found -> Just (form, said)
  _ -> Nothing
  where
    form = numberTemplate example
    said = fmap (\fields -> SensorLine [Message (routeChannel route) fields]) . decodedNumbers route
    example = Lazy.toStrict (Builder.toLazyByteString (publishing route values))
    -- As many numbers as the channel has values, all different.
    values = fromMaybe [] (find (isJust . channelShow (routeChannel route)) [map Number (take n [0.125, 0.25 ..]) | n <- [1 .. 20]])

stepForm :: Bool -> Bool -> Bool -> (NumberTemplate, [Double] -> Maybe Line)
stepForm looks watches late = (numberTemplate ("{\"op\":\"step\",\"step\":0,\"time\":0.0" <> member "memory" looks <> member "firings" watches <> member "late" late <> "}"), said)
  where
    member name on = if on then ",\"" <> name <> "\":true" else ""
    said found = case found of
      [step, time] | let n = truncate step, fromIntegral n == step -> Just (StepLine n time looks watches late)
      _ -> Nothing

line :: [String] -> Object -> Parser Line
line taken o = do
  op <- o .: "op"
  case op :: Text of
    "publish" -> do
      topic <- o .: "topic"
      msg <- o .: "msg"
      let name = absolute (Text.unpack topic)
          own = [OpenMessage name msg | name `elem` taken]
      case readMessages pipeRoutes topic msg of
        Left why | null own -> fail why
        found -> pure (SensorLine (fromRight [] found ++ own))
    "step" -> StepLine <$> o .: "step" <*> o .: "time" <*> o .:? "memory" .!= False <*> o .:? "firings" .!= False <*> o .:? "late" .!= False
    "start" -> StartLine <$> o .: "protocol" <*> o .: "seed" <*> o .:? "clock" .!= 0 <*> o .:? "trace" .!= False <*> o .:? "quiet" .!= False
    "stop" -> pure StopLine
    _ | isReply op -> pure (SensorLine [ReplyMessage (Object o)])
    _ -> fail ("unknown op " ++ show op)

-- | The channels of the simulated robot, as the pipe has them: without the fields of a message that are always the same, and with a field for
-- what robots compute from others.
pipeRoutes :: [Route]
pipeRoutes = case robotProfiles simulated of
  (_, variables) : _ -> routes simulated {robotMappings = [m {mappingConstants = [], mappingPlaces = map ownField (mappingPlaces m)} | m <- robotMappings simulated]} variables
  [] -> []
  where
    ownField p = case p of
      NearestAhead _ -> At [Key "ahead"] (ANumber 1)
      _ -> p

-- ---------------------------------------------------------------------------------------------
-- What leaves

-- | The lines before the first step: the program's own topics, and that it is ready, perhaps with its mailbox. Both ends know the robot's
-- topics from its description.
writeOpening :: Bool -> [Topic] -> Builder
writeOpening usesMailbox own =
  foldMap (topicLine "advertise") [t | t <- own, topicUse t == Sent]
    <> foldMap (topicLine "subscribe") [t | t <- own, topicUse t == Taken]
    <> (if usesMailbox then "{\"op\":\"ready\",\"mailbox\":true}\n" else "{\"op\":\"ready\"}\n")
  where
    topicLine op t =
      "{\"op\":\"" <> op <> "\",\"topic\":" <> text (topicName t)
        <> (",\"type\":" <> text (topicType t) <> "}\n")

-- | What answers tell beside what fired: with trace what was heard and said in words, and how many of the next steps are quiet.
data Telling = Telling {tellsTrace :: Bool, tellsQuiet :: Bool}

-- | A batch: commands in firing order, then that the program has settled. With trace also in words.
writeAnswer :: Telling -> Answer -> Builder
writeAnswer telling a =
  foldMap action (answerActions a)
    <> literal "{\"op\":\"settled\",\"step\":"
    <> Builder.intDec (answerStep a)
    <> done telling a
    <> (if null listening then mempty else literal ",\"listens\":" <> list (text . channelName) listening)
    <> (if tellsQuiet telling && quiet > 0 then literal ",\"quiet\":" <> Builder.intDec quiet else mempty)
    <> literal "}\n"
  where
    quiet = quietSteps (answerStep a) (answerQuiescence a)
    listening = [c | c <- robotOnDemand simulated, interestedIn (wakingInterest (answerQuiescence a)) (channelInterest c)]

-- | The last batch: commands, zero velocity, and how the program ended. With trace also in words.
writeEnding :: Telling -> Answer -> Ending -> Builder
writeEnding telling a ending =
  foldMap action (answerActions a')
    <> "{\"op\":\"ended\",\"how\":"
    <> ( case ending of
           EndedDone -> "\"done\""
           EndedStopped -> "\"stopped\""
           EndedError p -> "\"error\",\"problem\":" <> problem p
       )
    <> done telling a'
    <> "}\n"
  where
    a' = a {answerActions = answerActions a ++ [Action c rest | r <- commandRoutes pipeRoutes, let c = routeChannel r, Just rest <- [channelRest c]]}

-- | What fired in a step and what was sensed, with trace what was heard and said, and what is remembered when it is requested.
done :: Telling -> Answer -> Builder
done telling a =
  literal ",\"fired\":"
    <> list (text . nameText) (answerFired a)
    <> sent (answerSent a)
    <> (if null (answerSensed a) then mempty else literal ",\"sensed\":" <> list text (answerSensed a))
    <> ( if tellsTrace telling
           then literal ",\"events\":" <> list text (answerEvents a) <> literal ",\"commands\":" <> list (text . tellAction) (answerActions a)
           else mempty
       )
    <> foldMap (\kept -> literal ",\"memory\":" <> list remember kept) (answerMemory a)
    <> foldMap (\found -> literal ",\"firings\":" <> list record found) (answerRecords a)
  where
    -- One function sent all commands of its step.
    sent counts@(_ : _ : _) | any (> 0) counts = literal ",\"sent\":" <> list Builder.intDec counts
    sent _ = mempty
    remember (what, value) = literal "{\"type\":" <> text what <> literal ",\"value\":" <> text value <> literal "}"

-- | A firing with its provenance.
record :: Record -> Builder
record r =
  literal "{\"n\":" <> Builder.intDec (recordNumber r) <> literal ",\"function\":" <> text (recordFunction r) <> literal ",\"task\":" <> Builder.intDec (recordTask r)
    <> literal ",\"cause\":{\"by\":"
    <> reason (recordReason r)
    <> literal "},\"took\":"
    <> list input (recordInputs r)
    <> literal ",\"gave\":"
    <> list output (recordOutputs r)
    <> (if null (recordBranches r) then mempty else literal ",\"branches\":" <> list (Builder.byteString . takenText) (recordBranches r))
    <> literal "}"
  where
    reason why = case why of
      OfMessage at shown -> literal "\"message\"" <> instant at <> value shown
      OfTick at -> literal "\"tick\"" <> instant at
      OfEvent n by -> literal "\"event\"" <> event n <> from by
      OfStart -> literal "\"start\""
      OfWait at -> literal "\"instant\"" <> instant at
      OfFiring by -> literal "\"task\"" <> from by
      OfEnd -> literal "\"end\""
    input (Input origin shown) = literal "{\"from\":" <> place origin <> value shown <> literal "}"
    place origin = case origin of
      AnEvent -> literal "\"event\""
      AState channel at -> literal "\"state\",\"channel\":" <> text channel <> foldMap instant at
      AMemory what by -> literal "\"memory\"" <> typed ("Memory " ++ what) <> from by
      AParam what by -> literal "\"param\"" <> typed ("Param " ++ what) <> from by
      ATime -> literal "\"time\""
      AGenerator n -> literal "\"generator\",\"read\":" <> Builder.intDec n
    output (Output sink shown) =
      literal "{\"to\":"
        <> ( case sink of
               ACommand what -> literal "\"command\"" <> typed what <> value shown
               AnEmission what n -> literal "\"event\"" <> typed what <> event n <> value shown
               IntoMemory what -> literal "\"memory\"" <> typed ("Memory " ++ what) <> value shown
               IntoParam what -> literal "\"param\"" <> typed ("Param " ++ what) <> value shown
               ADone -> literal "\"done\"" <> value shown
               AFeedback -> literal "\"feedback\"" <> value shown
               ACall -> literal "\"call\""
           )
        <> literal "}"
    instant n = literal ",\"instant\":" <> Builder.intDec n
    event n = literal ",\"event\":" <> Builder.intDec n
    value shown = literal ",\"value\":" <> text shown
    typed what = literal ",\"type\":" <> text what
    from = foldMap (\n -> literal ",\"firing\":" <> Builder.intDec n)

-- | A branch as the record of a firing has it.
branchText :: Branch -> ByteString
branchText (from, to, definitions, kind, number, shown) =
  Lazy.toStrict . Builder.toLazyByteString $
    "{\"in\":" <> list text definitions <> ",\"kind\":" <> text kind <> ",\"number\":" <> Builder.intDec number
      <> (",\"text\":" <> text shown <> ",\"start\":" <> position from <> ",\"end\":" <> position to <> "}")

object :: [(Builder, Builder)] -> Builder
object fields = "{" <> mconcat (intersperse "," ["\"" <> key <> "\":" <> value | (key, value) <- fields]) <> "}"

action :: Action -> Builder
action (OpenAction name message) =
  "{\"op\":\"publish\",\"topic\":" <> text name <> ",\"msg\":" <> Encoding.fromEncoding (Encoding.value message) <> "}\n"
action (RequestAction frame) = Encoding.fromEncoding (Encoding.value frame) <> "\n"
action (Action c fields) = maybe mempty ($ fields) (IntMap.lookup (channelNumber c) publishers)

-- | By the number of a command's channel, its line.
publishers :: IntMap.IntMap ([Field] -> Builder)
publishers = IntMap.fromList [(channelNumber (routeChannel route), line' route) | route <- commandRoutes pipeRoutes]
  where
    line' route = let written = publishing route in \fields -> written fields <> literal "\n"

-- | The message of a channel without its line end. Partial application prepares it.
publishing :: Route -> [Field] -> Builder
publishing route =
  let before = "{\"op\":\"publish\",\"topic\":" <> Encoding.fromEncoding (Encoding.text (routeTopic route)) <> ",\"msg\":"
      written = encode route
   in \fields -> before <> Encoding.fromEncoding (written fields) <> "}"

problem :: Problem -> Builder
problem p =
  "{\"severity\":\"error\",\"kind\":" <> text (problemKind p)
    <> foldMap (\f -> ",\"function\":" <> text f) (problemFunction p)
    <> ",\"message\":"
    <> sentence (problemMessage p)
    <> ",\"hint\":"
    <> sentence (problemHint p)
    <> (if null translated then mempty else ",\"sentences\":" <> object translated)
    <> ",\"ghc\":"
    <> text (problemOriginal p)
    <> foldMap (\t -> ",\"time\":" <> Builder.doubleDec t) (problemTime p)
    <> ",\"inputs\":"
    <> list text (problemInputs p)
    <> foldMap (\(from, to) -> ",\"start\":" <> position from <> ",\"end\":" <> position to) (problemPlace p)
    <> "}"
  where
    sentence = text . Text.unpack . english
    translated = [(name, Encoding.fromEncoding (Encoding.value found)) | (name, said) <- [("message", problemMessage p), ("hint", problemHint p)], Just found <- [sentenceId said]]

position :: (Int, Int) -> Builder
position (l, c) = object [("line", Builder.intDec l), ("column", Builder.intDec c)]

-- | A text in JSON. Half a pair of surrogates, which Haskell lets stand in a text, cannot be written in UTF-8.
text :: String -> Builder
text shown = Builder.char7 '"' <> Prim.primMapListBounded character shown <> Builder.char7 '"'

-- | A piece of a line that is always the same. It is copied as a whole; a 'Builder' from a string literal is encoded letter by letter
-- each time before bytestring 0.11.
literal :: ByteString -> Builder
literal = Builder.byteStringCopy
{-# INLINE literal #-}

-- | A character of a text in JSON (RFC 8259, section 7), as aeson writes it. Inlined, a text is written without memory for each character.
character :: Prim.BoundedPrim Char
{-# INLINE character #-}
character =
  Prim.condB (\c -> c >= ' ' && c <= '~' && c /= '"' && c /= '\\') (Prim.liftFixedToBounded Prim.char7) $
    Prim.condB (> '~') (Prim.condB (\c -> c >= '\xD800' && c <= '\xDFFF') (const '\xFFFD' Prim.>$< Prim.charUtf8) Prim.charUtf8) $
      Prim.condB (\c -> c == '"' || c == '\\') (escaped id) $
        Prim.condB (== '\n') (escaped (const 'n')) $
          Prim.condB (== '\r') (escaped (const 'r')) $
            Prim.condB (== '\t') (escaped (const 't')) $
              Prim.liftFixedToBounded (hexadecimal Prim.>$< Prim.char7 Prim.>*< Prim.char7 Prim.>*< Prim.word16HexFixed)
  where
    escaped letter = Prim.liftFixedToBounded ((\c -> ('\\', letter c)) Prim.>$< Prim.char7 Prim.>*< Prim.char7)
    hexadecimal c = ('\\', ('u', fromIntegral (fromEnum c)))

list :: (a -> Builder) -> [a] -> Builder
list _ [] = literal "[]"
list f (x : xs) = Builder.char7 '[' <> f x <> foldMap (\y -> Builder.char7 ',' <> f y) xs <> Builder.char7 ']'

-- ---------------------------------------------------------------------------------------------
-- Steps

-- | The default rate is 10 Hz and a step is 20 ms: every fifth step ticks (protocol/README.md).
ticksEvery :: Int
ticksEvery = 5

-- | Steps per second of the simulator (protocol/README.md).
stepsPerSecond :: Double
stepsPerSecond = 50

-- | The most steps that are called quiet at once. A choice of ours: 10 s.
mostQuiet :: Int
mostQuiet = 500

-- | How many of the steps after this one need no answer as long as no event happens and no message of the program's own topics arrives.
-- The step before a moment counts as one that needs an answer, for times are sums of rounded numbers.
quietSteps :: Int -> Quiescence -> Int
quietSteps step (Quiescence until' waking)
  | interestedIn waking stateInterest = 0
  | otherwise = max 0 (min beforeTick beforeMoment)
  where
    beforeTick = if interestedIn waking tickInterest then ticksEvery - 1 - step `mod` ticksEvery else mostQuiet
    beforeMoment = floor (max 0 (min (fromIntegral mostQuiet) (until' * stepsPerSecond - fromIntegral (step + 2)))) :: Int

-- | The messages that come without an event: odometry and the changes of states.
stateInterest :: Interest
stateInterest = foldr (unite . channelInterest) clockInterest [c | r <- sensorRoutes pipeRoutes, let c = routeChannel r, channelKind c /= EventChannel]
