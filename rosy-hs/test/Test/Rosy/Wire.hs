{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE TupleSections #-}

-- |
-- Module      : Test.Rosy.Wire
-- Description : The golden conversations of protocol/goldens/link, held over a real socket.
--
-- Each file has a program of its name here. The simulator's lines go in; the program's lines must be those of the file.
-- With UPDATE_GOLDENS=1 in the environment the files are written anew instead; read the difference before you keep it.
module Test.Rosy.Wire (tests) where

import Control.Exception (bracket, catch)
import Data.Aeson (Value (..), object, (.:), (.=))
import qualified Data.Aeson as Aeson
import Data.Aeson.Types (parseMaybe)
import qualified Data.ByteString as ByteString
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Char8 as Char8
import qualified Data.ByteString.Lazy as Lazy
import Data.List (isInfixOf, nub, sort)
import Data.Word (Word32)
import Foreign.Marshal.Alloc (allocaBytes)
import Foreign.Marshal.Utils (copyBytes)
import Foreign.Ptr (nullPtr, plusPtr)
import Foreign.Storable (peek, peekByteOff, poke, pokeByteOff)
import Network.Socket
import Network.Socket.ByteString (recv, sendAll)
import Rosy
import Rosy.Core (functionName, nameBytes)
import Rosy.Launch (onLink)
import Rosy.Link (Answer (..), Batch (..), Link (..), noAnswer)
import Rosy.Link.Mailbox (noMailbox)
import Rosy.Link.Pipe (pipeLink)
import Rosy.Problem (Fault)
import Rosy.Program (Names (..), simulateNamed, taskNamed)
import Rosy.Robot
import Rosy.Wire
import Rosy.Wire.NumberTemplate
import System.Directory (listDirectory)
import System.Environment (lookupEnv)
import System.FilePath (dropExtension, takeExtension, (</>))
import Test.Tasty (TestTree, testGroup)
import Test.Tasty.HUnit
import Test.Tasty.QuickCheck (testProperty, (===))

tests :: TestTree
tests =
  testGroup
    "Wire and Pipe"
    [ testGroup "hold the golden conversations" [testCase name (converse name main') | (name, main') <- programs],
      testCase "every golden conversation has a program here" $ do
        files <- listDirectory goldens
        sort [dropExtension f | f <- files, takeExtension f == ".jsonl"] @?= sort (map fst programs),
      testCase "a line outside the protocol ends the program with a problem" $ do
        told <- held [start, "{\"op\":\"dance\"}"] (simulate (Velocity 0.5 0))
        assertBool (show told) ("malformed" `isInfixOf` show (last told)),
      testCase "a second simulate is told, not run" $ do
        told <- held [start, step0, stop'] (simulate (Say "one") >> simulate (Say "two"))
        length [() | a <- told, "two" `isInfixOf` show a] @?= 0,
      testCase "a main without simulate ends as done, with the wheels at rest" $ do
        told <- held [start] (pure ())
        map Line' told @?= map Line' [object ["op" .= publishes, "topic" .= velocity, "msg" .= object ["linear" .= object ["x" .= zero], "angular" .= object ["z" .= zero]]], object ["op" .= ended, "how" .= done, "fired" .= ([] :: [String])]],
      testCase "the name of the function at work is whole at every moment: the next is written beside the one that is shown" $
        allocaBytes 4096 $ \page -> do
          poke page (0 :: Word32)
          link <- pipeLink 0 page noMailbox
          let bytesAt place = do
                size <- peekByteOff page place :: IO Word32
                ByteString.packCStringLen (page `plusPtr` (place + 4), fromIntegral size)
              works :: String -> IO Int
              works name = atWork link (functionName name) >> fromIntegral <$> peek page
          places <- forM ["first", "second", "das Größte", replicate 5000 'z'] $ \name -> do
            place <- works name
            shown' <- bytesAt place
            shown' @?= ByteString.take 2040 (nameBytes (functionName name))
            _ <- works "next"
            still <- bytesAt place
            still @?= shown'
            pure place
          length (nub places) @?= 1
          atRest link
          atRest' <- peek page
          atRest' @?= 0,
      testCase "what was said with a batch of where the next one comes holds, also when it changes as soon as that batch is answered" $
        bracket (socketPair AF_UNIX Stream defaultProtocol) (\(a, b) -> close a >> close b) $ \(ours, theirs) ->
          allocaBytes 65536 $ \mailbox -> withFdSocket theirs $ \fd -> do
            link <- pipeLink fd nullPtr mailbox
            let stepAt :: Int -> ByteString.ByteString
                stepAt n = Char8.pack ("{\"op\":\"step\",\"step\":" ++ show n ++ ",\"time\":0}\n")
                -- Places of protocol/README.md, section 2.
                expect isHere = pokeByteOff mailbox 128 (if isHere then 1 else 0 :: Word32)
                put bytes = do
                  ByteString.useAsCStringLen bytes (uncurry (copyBytes (mailbox `plusPtr` 4096)))
                  pokeByteOff mailbox 0 (fromIntegral (ByteString.length bytes) :: Word32)
                takes :: Int -> IO ()
                takes n = next link >>= (@?= Just n) . fmap batchStep
            forM_ [0, 64, 128] $ \place -> pokeByteOff mailbox place (0 :: Word32)
            sendAll ours (start <> "\n")
            _ <- open link []
            expect True
            sendAll ours (stepAt 0)
            takes 0
            answer link noAnswer
            put (stepAt 1)
            takes 1
            answer link noAnswer
            expect False
            put (stepAt 2)
            sendAll ours (stepAt 3)
            takes 2
            answer link noAnswer
            takes 3,
      testCase "a heading comes out of the quaternion" $
        case readLine (odom "0.5" "0.8660254037844386") of
          Right (SensorLine [OdometryMessage o]) -> do
            (odometryPosition o, odometryVelocity o) @?= (Position 1 2, Velocity 0.5 0.25)
            assertBool (show o) (abs (odometryOrientation o - Orientation (pi / 3)) < 1e-9)
          other -> assertFailure (show other),
      testCase "a heading is never outside -π to π" $
        case readLine (odom "-0.7071067811865476" "-0.7071067811865475") of
          Right (SensorLine [OdometryMessage o]) -> assertBool (show o) (abs (odometryOrientation o - Orientation (pi / 2)) < 1e-9)
          other -> assertFailure (show other),
      testProperty "the lines of each step say what they say with other spaces, which are read as JSON" $ \step time x y z w v a ->
        and
          [ readLine plain == readLine ("{ " <> ByteString.drop 1 plain)
            | asks <- ["", ",\"memory\":true", ",\"firings\":true", ",\"memory\":true,\"firings\":true", ",\"late\":true"],
              plain <-
                [ "{\"op\":\"step\",\"step\":" <> number (abs step :: Int) <> ",\"time\":" <> number (time :: Double) <> asks <> "}",
                  "{\"op\":\"publish\",\"topic\":\"/odom\",\"msg\":{\"pose\":{\"pose\":{\"position\":{\"x\":" <> number (x :: Double) <> ",\"y\":" <> number (y :: Double)
                    <> ("},\"orientation\":{\"z\":" <> number (z :: Double) <> ",\"w\":" <> number (w :: Double))
                    <> ("}}},\"twist\":{\"twist\":{\"linear\":{\"x\":" <> number (v :: Double) <> "},\"angular\":{\"z\":" <> number (a :: Double) <> "}}}}}")
                ]
          ],
      testProperty "a text of any characters is written as aeson writes it, half a pair of surrogates as U+FFFD" $ \shown ->
        let half c = if c >= '\xD800' && c <= '\xDFFF' then '\xFFFD' else c
            answered = writeAnswer (Telling False False) noAnswer {answerSensed = [shown, ['\0' .. '\x100'], "\xD800\xDFFF\xE000"]}
         in Builder.toLazyByteString answered === "{\"op\":\"settled\",\"step\":0,\"fired\":[],\"sensed\":" <> Aeson.encode (map (map half) [shown, ['\0' .. '\x100'], "\xD800\xDFFF\xE000"]) <> "}\n",
      testCase "a template reads the numbers of lines of its form, and of no others" $ do
        let form = numberTemplate "{\"x\\\"1\":1,\"y\":[2.5,-3]}"
            reads' = numbersIn form
        reads' "{\"x\\\"1\":0.1,\"y\":[-1e-3,17]}" @?= Just [0.1, -0.001, 17]
        reads' "{\"x\\\"1\":0.30000000000000004,\"y\":[5e-324,1.7976931348623157e308]}" @?= Just [0.30000000000000004, 5.0e-324, 1.7976931348623157e308]
        map show <$> reads' "{\"x\\\"1\":-0.0,\"y\":[0,1]}" @?= Just ["0.0", "0.0", "1.0"]
        mapM_
          (\other -> reads' other @?= Nothing)
          ["", "{\"x\\\"1\":1", "{\"x\\\"1\":null,\"y\":[2,3]}", "{\"x\\\"1\":1,\"y\":[2,3]} ", "{\"x\\\"1\":1,\"y\":[2,3,4]}", "{\"x\\\"1\":0x1,\"y\":[2,3]}", "{\"x\\\"1\":1-2,\"y\":[2,3]}"],
      testCase "a number out of range is refused" $
        assertBool "" (either (const True) (const False) (readLine "{\"op\":\"publish\",\"topic\":\"/mobile_base/events/bumper\",\"msg\":{\"bumper\":3,\"state\":1}}"))
    ]
  where
    start = "{\"op\":\"start\",\"protocol\":1,\"seed\":1,\"trace\":false}"
    step0 = "{\"op\":\"step\",\"step\":0,\"time\":0}"
    stop' = "{\"op\":\"stop\"}"
    (publishes, velocity, ended, done) = ("publish", "/mobile_base/commands/velocity", "ended", "done") :: (String, String, String, String)
    zero = 0 :: Double
    number :: Show n => n -> ByteString.ByteString
    number = Char8.pack . show
    odom z w =
      ByteString.concat
        [ "{\"op\":\"publish\",\"topic\":\"/odom\",\"msg\":{\"header\":{\"seq\":3},\"pose\":{\"pose\":{\"position\":{\"x\":1,\"y\":2.0,\"z\":0},\"orientation\":{\"x\":0,\"y\":0,\"z\":",
          z,
          ",\"w\":",
          w,
          "}}},\"twist\":{\"twist\":{\"linear\":{\"x\":0.5,\"y\":0},\"angular\":{\"z\":0.25}}}}}"
        ]

goldens :: FilePath
goldens = "protocol/goldens/link"

-- | The program of each conversation, with the names that the worker would find in its text.
programs :: [(String, IO ())]
programs =
  [ ("move", simulateNamed (Name "main") (Velocity 0.5 0)),
    ("bump", simulateNamed (Names [Name "accelerate", Name "play"]) (accelerate, play)),
    ("said", simulateNamed (Names [Name "greet", Name "light"]) (greet, light)),
    ("error", simulateNamed (Names [Name "retreat"]) [retreat]),
    ("done", simulate (taskNamed (Name "start") (Names [Name "accelerate", Name "untilBump"]) (Led1 Green) (accelerate, untilBump))),
    ("events", simulateNamed (Names [Name "lift", Name "alarm", Name "count"]) (lift, alarm, count)),
    ("memory", simulateNamed (Names [Name "hold", Name "share"]) (hold, share)),
    ("firings", simulateNamed (Names [Name "bump", Name "forwardBackward", Name "report"]) (remember, forwardBackward, report)),
    ("quiet", simulateNamed (Names [Name "onBump", Name "patrol"]) (onBump, patrol))
  ]
  where
    onBump :: Bumper -> Velocity -> Say
    onBump (Bumper _ _) v = Say (show v)
    patrol :: Task ()
    patrol = once (Velocity 0.5 0) >> wait 2 >> once (Say . show :: Position -> Say)
    remember :: Bumper -> (Memory Bool, Cancel)
    remember _ = (Memory True, Cancel)
    forwardBackward :: Memory Bool -> Velocity -> Velocity
    forwardBackward (Memory hit) (Velocity v w) = if hit then Velocity (v - 0.5) w else Velocity (v + 0.5) w
    report :: Cancel -> Seconds -> Say
    report _ s = Say (show s)
    accelerate :: Velocity -> Velocity
    accelerate (Velocity v w) = Velocity (v + 0.5) w
    play :: Bumper -> Maybe Sound
    play (Bumper _ Pressed) = Just ErrorSound
    play _ = Nothing
    greet :: Button -> Maybe Say
    greet (Button n Pressed) = Just (Say ("Hello, \"" ++ show n ++ "\" — günaydın!\n"))
    greet _ = Nothing
    light :: ButtonOne -> (Led1, Led2)
    light (ButtonOne Pressed) = (Led1 Orange, Led2 Red)
    light _ = (Led1 Black, Led2 Black)
    retreat :: Cliff -> Velocity -> Velocity
    retreat (Cliff LeftCliff _) v = v
    retreat (Cliff _ Hole) _ = errorWithoutStackTrace "which way is back?"
    retreat _ v = v
    untilBump :: Bumper -> (Led1, Done ())
    untilBump _ = (Led1 Black, Done ())
    lift :: Wheel -> Memory Int -> Either Cancel (Memory Int)
    lift (Wheel _ Air) _ = Left Cancel
    lift _ (Memory n) = Right (Memory (n + 10))
    alarm :: Cancel -> Orientation -> Sound
    alarm Cancel _ = ErrorSound
    -- A value without end and one that cannot be shown.
    hold :: Button -> Memory Int -> (Memory Int, Memory [Int], Memory [Int -> Int])
    hold _ (Memory n) = (Memory (n + 1), Memory [n ..], Memory [(+ n)])
    share :: Bumper -> Param Bool
    share _ = Param True
    count :: Maybe Cancel -> Memory Int -> (Memory Int, Say)
    count c (Memory n) = (Memory (n + 1), Say (maybe "tick " (const "cancel ") c ++ show n))

-- | Hold the conversation of a file.
converse :: String -> IO () -> Assertion
converse name main' = do
  let file = goldens </> name ++ ".jsonl"
  entries <- map parsed . Char8.lines <$> ByteString.readFile file
  let simulator = [l | ("sim", l) <- entries]
      program = [l | ("prog", l) <- entries]
  answers <- held (map (Lazy.toStrict . Aeson.encode) simulator) main'
  accepted <- lookupEnv "UPDATE_GOLDENS"
  case accepted of
    Just _ -> ByteString.writeFile file (Char8.unlines (map (Lazy.toStrict . Aeson.encode . entry) (interleaved simulator answers)))
    Nothing -> do
      mapM_ (uncurry (assertEqual "line by line")) (zip (map Line' answers) (map Line' program))
      length answers @?= length program
  where
    parsed bytes = case Aeson.decodeStrict' bytes >>= parseMaybe (\o -> (,) <$> o .: "from" <*> o .: "line") of
      Just (from, l) -> (from :: String, l :: Value)
      Nothing -> error ("not a line of a conversation: " ++ show bytes)
    entry (from, l) = object ["from" .= (from :: String), "line" .= l]

newtype Line' = Line' Value deriving (Eq)

instance Show Line' where
  show (Line' v) = Char8.unpack (Lazy.toStrict (Aeson.encode v))

-- | Each side speaks until its batch ends. A late step does not end one.
interleaved :: [Value] -> [Value] -> [(String, Value)]
interleaved [] prog = map ("prog",) prog
interleaved sim prog = map ("sim",) batch ++ map ("prog",) reply ++ interleaved sim' prog'
  where
    (batch, sim') = through ["start", "step", "stop"] sim
    (reply, prog') = through ["ready", "settled", "ended"] prog
    through ops ls = case break (\l -> op l `elem` map Just ops && not (isLate l)) ls of
      (before, l : rest) -> (before ++ [l], rest)
      (before, []) -> (before, [])
    op :: Value -> Maybe String
    op (Object o) = parseMaybe (.: "op") o
    op _ = Nothing
    isLate :: Value -> Bool
    isLate (Object o) = parseMaybe (.: "late") o == Just True
    isLate _ = False

-- | Say these lines to a program over a socket, hang up, and hear all that it said.
held :: [ByteString.ByteString] -> IO () -> IO [Value]
held ls main' = bracket (socketPair AF_UNIX Stream defaultProtocol) (\(a, b) -> close a >> close b) $ \(ours, theirs) -> do
  sendAll ours (Char8.unlines ls)
  shutdown ours ShutdownSend
  -- Not onPipe, which takes the standard output of the process: the tests print at the same time.
  withFdSocket theirs (\fd -> (pipeLink fd nullPtr noMailbox >>= (`onLink` main')) `catch` lost)
  shutdown theirs ShutdownSend
  bytes <- readAll ours
  pure (map decoded (Char8.lines bytes))
  where
    lost :: Fault -> IO ()
    lost _ = pure ()
    readAll s = do
      piece <- recv s 65536
      if ByteString.null piece then pure "" else (piece <>) <$> readAll s
    decoded bytes = case Aeson.decodeStrict' bytes of
      Just v -> v
      Nothing -> error ("the program did not say JSON: " ++ show bytes)
