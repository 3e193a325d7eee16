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
import Rosy.Core
import Rosy.Link
import Rosy.Loop
import Rosy.Problem
import System.Random (mkStdGen)

-- | Run a program on a link until it ends, is stopped, or fails. A lost link is thrown as a 'Fault'.
runOn :: Link -> Program r -> IO ()
runOn link program = do
  opening <- open link
  first <- next link
  case first of
    Nothing -> end link noAnswer EndedStopped
    Just batch -> do
      between link
      let start = Start {startTime = batchTime batch, startGen = mkStdGen (openingSeed opening)}
      batches link [] batch (Ended (Report [] [])) (begin start program)

-- | Go through one batch, starting from a turn, then wait for the next. The memory is as it was seen last.
batches :: Link -> [(String, String)] -> Batch -> Turn -> Turn -> IO ()
batches link seen batch = drive "main" [] (occasions batch)
  where
    failed name inputs exception = EndedError (problemFrom (Just name) inputs (Just (batchTime batch)) exception)
    -- Who says what comes next, the names of what fired, newest first, what of the batch is to come, and what follows when what comes
    -- next cannot be computed.
    drive name fired todo instead next' = do
      computed <- try (evaluate next')
      case computed of
        Right turn -> follow fired todo turn
        Left exception -> cleanUp link batch fired (failed name [] exception) instead
    follow fired todo turn = case turn of
      Fires firing after -> do
        let name = firingName firing
        atWork link name
        result <- try (evaluate (firingEffects firing))
        case result of
          Right _ -> between link >> drive "main" (name : fired) todo (firingFailed firing) after
          Left exception -> do
            inputs <- showInputs (firingInputs firing)
            cleanUp link batch fired (failed (nameText name) inputs exception) (firingFailed firing)
      Settled network -> case todo of
        what : rest -> drive "main" fired rest (stop network) (instant (batchTime batch) what network)
        [] -> do
          atRest link
          let (report, network') = collect network
          memory <- if batchLooks batch then showMemory (remembered network') else pure seen
          answer link (answerOf batch fired report) {answerMemory = if memory == seen then Nothing else Just memory}
          following <- next link
          case following of
            Nothing -> cleanUp link batch [] EndedStopped (stop network')
            Just batch' -> between link >> batches link memory batch' (stop network') (Settled network')
      Enters name instead after -> atWork link name >> drive (nameText name) fired todo instead after
      Closes outcome after -> cleanUp link batch fired (endingOf batch outcome) after
      Ended report -> end link (answerOf batch fired report) EndedStopped

-- | Between two firings the program's own expressions are at work: they say which task comes next. A loop of tasks that never lets
-- time pass is stuck there. It begins in @main@, and 'Enters' tells of other definitions.
between :: Link -> IO ()
between link = atWork link (functionName "main")

-- | What was done in a step, given the names of what fired, newest first.
answerOf :: Batch -> [FunctionName] -> Report -> Answer
answerOf batch fired report =
  Answer
    { answerStep = batchStep batch,
      answerActions = reportActions report,
      answerFired = reverse fired,
      answerEvents = reportEvents report,
      answerMemory = Nothing
    }

-- | The instants of a batch in order.
occasions :: Batch -> [What]
occasions batch = map Hear (batchMessages batch) ++ [TickNow | batchTick batch]

-- | Let the live tasks clean up, after what has fired in this step, newest first; a clean-up that fails itself is passed over, for the first failure is the one to tell.
cleanUp :: Link -> Batch -> [FunctionName] -> Ending -> Turn -> IO ()
cleanUp link batch fired ending turn = case turn of
  Fires firing after -> do
    atWork link (firingName firing)
    result <- try (evaluate (firingEffects firing)) :: IO (Either SomeException Effects)
    case result of
      Right _ -> between link >> cleanUp link batch (firingName firing : fired) ending after
      Left _ -> cleanUp link batch fired ending (firingFailed firing)
  Enters name _ after -> atWork link name >> cleanUp link batch fired ending after
  Closes _ after -> cleanUp link batch fired ending after
  Settled network -> cleanUp link batch fired ending (stop network)
  Ended report -> atRest link >> end link (answerOf batch fired report) ending

endingOf :: Batch -> Outcome -> Ending
endingOf batch outcome = case outcome of
  Finished -> EndedDone
  EndedWrongly who given wanted -> failed who (WrongDone given wanted)
  CalledInOnce who -> failed who CallInOnce
  where
    failed who fault = EndedError (problemFrom (Just who) [] (Just (batchTime batch)) (toException fault))

-- | Inputs as text, each cut to a length that fits a message.
showInputs :: [String] -> IO [String]
showInputs = mapM showValue . take 20

-- | What is remembered, as much of it as a page can show.
showMemory :: [(String, String)] -> IO [(String, String)]
showMemory = mapM (\(what, value) -> (,) what <$> showValue value) . take memoryLength

-- | Cut to a length that fits a message; a value that fails itself is told as @_@.
showValue :: String -> IO String
showValue value = do
  result <- try (let text = take inputLength value in evaluate (foldr seq text text))
  pure (either (const "_" :: SomeException -> String) id result)

-- | The most values of a memory that are shown. A choice of ours.
memoryLength :: Int
memoryLength = 50

-- | Longest text of one input in a problem, or of one value in a memory, characters. A choice of ours.
inputLength :: Int
inputLength = 200
