{-# LANGUAGE BangPatterns #-}

-- |
-- Module      : Rosy.Run
-- Description : Drives the loop over a link: hears batches, fires, answers.
--
-- This is the only place where the pure loop meets the world. It evaluates the firings one by one,
-- says before each which function is at work, and turns what a function throws into a problem that names it.
module Rosy.Run
  ( runOn,
  )
where

import Control.Exception
import Control.Monad (unless)
import Data.Maybe (fromMaybe)
import Rosy.BranchCoverage (TakenBranch (..), recordingBranches)
import Rosy.Channel (Channel (..), Kind (..), Message (..), tellMessage)
import Rosy.Core hiding (Message)
import Rosy.Link
import Rosy.Loop
import Rosy.Problem
import Rosy.Provenance
import System.Random (mkStdGen)

-- | Run a program with topics of its own on a link until it ends, is stopped, or fails. A lost link is thrown as a 'Fault'.
runOn :: Link -> [Topic] -> Program r -> IO ()
runOn link topics program = do
  opening <- open link topics
  first <- next link
  case first of
    Nothing -> end link noAnswer EndedStopped
    Just batch -> do
      between link
      let start = Start {startTime = batchTime batch, startClock = openingClock opening, startGen = mkStdGen (openingSeed opening)}
      batches link (Told [] (if batchWatches batch then Just (watchFrom 0) else Nothing)) batch (Ended (Report [] [])) (begin start program)

-- | What was told of the program before: its memory, and its firings as far as they are observed.
data Told = Told
  { toldMemory :: [(String, String)],
    toldFirings :: Maybe Watch
  }

-- | What was done in a batch so far, newest first: what fired, and what an observation follows.
data Done = Done [Fired] [Observed]

-- | Go through one batch, starting from a turn, then wait for the next.
batches :: Link -> Told -> Batch -> Turn -> Turn -> IO ()
batches link told batch = drive "main" (Done [] []) (occasions batch)
  where
    failed name inputs exception = EndedError (problemFrom (Just name) inputs (Just (batchTime batch)) exception)
    finish = cleanUp link (toldFirings told) batch
    -- Who says what comes next, what was done, what of the batch is to come, and what follows when what comes
    -- next cannot be computed.
    drive name done todo instead next' = do
      computed <- try (evaluate next')
      case computed of
        Right turn -> go done todo turn
        Left exception -> finish done (failed name [] exception) instead
    go done todo turn = case turn of
      Fires firing after -> do
        let name = firingName firing
        atWork link name
        result <- try (recordingBranches (batchWatches batch) (evaluate (firingEffects firing)))
        case result of
          Right (effects, branches) -> between link >> drive "main" (fired batch firing effects branches done) todo (firingFailed firing) after
          Left exception -> do
            inputs <- showInputs (firingInputs firing)
            finish done (failed (nameText name) inputs exception) (firingFailed firing)
      Settled network -> case todo of
        what : rest -> drive "main" (began batch what done) rest (stop network) (instant (batchTime batch) what network)
        [] -> do
          atRest link
          let (report, network') = collect network
          memory <- if batchLooks batch then showMemory (remembered network') else pure (toldMemory told)
          (watch, found) <- recordsOf batch (toldFirings told) done
          let answered = answerOf batch done report
          unless (batchLate batch) $
            answer link answered {answerMemory = if memory == toldMemory told then Nothing else Just memory, answerRecords = found, answerQuiescence = quiescence network'}
          following <- next link
          case following of
            Nothing -> cleanUp link watch batch {batchMessages = []} (Done [] []) EndedStopped (stop network')
            Just batch' -> do
              between link
              -- What happens without an observer is not known to the next one.
              let watch' = if batchWatches batch' then Just (fromMaybe (watchFrom (emissionsOf network')) watch) else Nothing
              batches link (Told memory watch') batch' (stop network') (Settled network')
      Enters name instead after -> atWork link name >> drive (nameText name) done todo instead after
      Closes outcome after -> finish done (endingOf batch outcome) after
      Ended report -> end link (answerOf batch done report) EndedStopped

-- | A function has fired.
fired :: Batch -> Firing -> Effects -> [TakenBranch] -> Done -> Done
fired batch firing effects branches (Done functions observed) = Done ((firingName firing, commandsIn effects) : functions) (if batchWatches batch then AFiring firing branches : observed else observed)

-- | An instant has begun.
began :: Batch -> What -> Done -> Done
began batch what done@(Done functions observed) = if batchWatches batch then Done functions (AnInstant what : observed) else done

-- | The firings of a batch with their provenance, and the watch after them; nothing while the run is not observed.
recordsOf :: Batch -> Maybe Watch -> Done -> IO (Maybe Watch, Maybe [Record])
recordsOf batch watch (Done _ observed) = case watch of
  Just before | batchWatches batch -> do
    let (after, found) = follow before (reverse observed)
    shown <- mapM showRecord (take recordLength found)
    after `seq` pure (Just after, Just (if sum (map most shown) <= recordText then shown else within recordText shown))
  _ -> pure (Nothing, Nothing)
  where
    -- At least as many characters as a record has.
    most r = inputLength * (length (recordInputs r) + length (recordOutputs r)) + sum (map takenSize (recordBranches r))
    -- The first records whose values have so many characters together.
    within left (r : rest) | size <= left = r : within (left - size) rest
      where
        size = sum ([length text | Input _ text <- recordInputs r] ++ [length text | Output _ text <- recordOutputs r] ++ map takenSize (recordBranches r))
    within _ _ = []

-- | Between two firings the program's own expressions are at work: they say which task comes next. A loop of tasks that never lets
-- time pass is stuck there. It begins in @main@, and 'Enters' tells of other definitions.
between :: Link -> IO ()
between link = atWork link (functionName "main")

-- | A function that fired, and the number of commands that it sent.
type Fired = (FunctionName, Int)

commandsIn :: Effects -> Int
commandsIn = go 0
  where
    go !n Nothing' = n
    go !n (Then effect rest) = go (case effect of Act _ -> n + 1; Arbitrated _ _ -> n + 1; _ -> n) rest

-- | What was done in a step.
answerOf :: Batch -> Done -> Report -> Answer
answerOf batch (Done functions _) report =
  Answer
    { answerStep = batchStep batch,
      answerActions = reportActions report,
      answerFired = map fst inOrder,
      answerSent = map snd inOrder,
      answerSensed = [tellMessage message | message@(Message c _) <- batchMessages batch, channelKind c == EventChannel],
      answerEvents = reportEvents report,
      answerMemory = Nothing,
      answerRecords = Nothing,
      answerQuiescence = neverQuiet
    }
  where
    inOrder = reverse functions

-- | The instants of a batch in order.
occasions :: Batch -> [What]
occasions batch = map Hear (batchMessages batch) ++ [TickNow | batchTick batch]

-- | Let the live tasks clean up, after what was done in this step; a clean-up that fails itself is passed over, for the first failure is the one to tell.
cleanUp :: Link -> Maybe Watch -> Batch -> Done -> Ending -> Turn -> IO ()
cleanUp link watch batch done ending turn = case turn of
  Fires firing after -> do
    atWork link (firingName firing)
    result <- try (recordingBranches (batchWatches batch) (evaluate (firingEffects firing))) :: IO (Either SomeException (Effects, [TakenBranch]))
    case result of
      Right (effects, branches) -> between link >> again (fired batch firing effects branches done) after
      Left _ -> again done (firingFailed firing)
  Enters name _ after -> atWork link name >> again done after
  Closes _ after -> again done after
  Settled network -> again done (stop network)
  Ended report -> do
    atRest link
    (_, found) <- recordsOf batch watch done
    end link (answerOf batch done report) {answerRecords = found} ending
  where
    again done' = cleanUp link watch batch done' ending

endingOf :: Batch -> Outcome -> Ending
endingOf batch outcome = case outcome of
  Finished -> EndedDone
  EndedWrongly who given wanted -> failed who (WrongDone given wanted)
  CalledInOnce who -> failed who CallInOnce
  where
    failed who fault = EndedError (problemFrom (Just who) [] (Just (batchTime batch)) (toException fault))

-- | Inputs as text, each cut to a length that fits a message.
showInputs :: [InputValue] -> IO [String]
showInputs inputs = mapM showValue [text | InputValue _ text <- take inputsShown inputs]

-- | A record with all its values as text, each cut to a length that fits a message.
showRecord :: Record -> IO Record
showRecord found = do
  isShort <- try (evaluate (isFew && and ([isWithin inputLength text | Input _ text <- recordInputs found] ++ [isWithin inputLength text | Output _ text <- recordOutputs found]))) :: IO (Either SomeException Bool)
  case isShort of
    Right True -> pure found
    _ -> cut
  where
    isFew = length (recordInputs found) <= inputsShown && length (recordOutputs found) <= outputsShown
    cut = do
      inputs <- mapM (\(Input origin text) -> Input origin <$> showValue text) (take inputsShown (recordInputs found))
      outputs <- mapM (\(Output sink text) -> Output sink <$> showValue text) (take outputsShown (recordOutputs found))
      pure found {recordInputs = inputs, recordOutputs = outputs}

-- | What is remembered, as much of it as a page can show.
showMemory :: [(String, String)] -> IO [(String, String)]
showMemory = mapM (\(what, value) -> (,) what <$> showValue value) . take memoryLength

-- | Cut to a length that fits a message; a value that fails itself is told as @_@.
showValue :: String -> IO String
showValue value = do
  result <- try (evaluate (if isWithin inputLength value then value else take inputLength value))
  pure (either (const "_" :: SomeException -> String) id result)

-- | Whether a text is shorter than so many characters; evaluates so many and nothing behind them.
isWithin :: Int -> String -> Bool
isWithin n characters = case characters of
  [] -> True
  c : rest -> c `seq` n > 1 && isWithin (n - 1) rest

-- | The most inputs and outputs of one firing that are shown. A choice of ours: a function takes at most 9 of each in one tuple.
inputsShown, outputsShown :: Int
inputsShown = 20
outputsShown = 20

-- | The most firings of one step that are told, and the most characters of all their values. Choices of ours: many times what a large
-- program has, and a line stays below the length that the simulator takes.
recordLength, recordText :: Int
recordLength = 200
recordText = 50000

-- | The most values of a memory that are shown. A choice of ours.
memoryLength :: Int
memoryLength = 50

-- | Longest text of one value in a problem, a memory or a firing, characters. A choice of ours.
inputLength :: Int
inputLength = 200
