-- |
-- Module      : Rosy.Model
-- Description : What a program means: timed happenings in, timed firings and commands out.
--
-- This is LANGUAGE.md section 2 once more, as code that cares for nothing but being right: lists, no threads, no I/O,
-- no cleverness. Where the page and the runtime ("Rosy.Loop") disagree with it, it is they who are wrong; the tests
-- compare the runtime with 'meaning' on generated programs and happenings.
--
-- Read "Rosy.Model.Program" first: what a program is. Then "Rosy.Model.Firing": when a function fires, and what one firing does
-- (rules 1 to 9). Here functions become tasks, and tasks a run (rules 8, 10 and 11).
--
-- An __ending__ ('Ending') stops whatever is going on at once, and only clean-ups follow it (rule 11).
module Rosy.Model
  ( -- * Programs, and time
    module Rosy.Model.Program,

    -- * Meaning
    meaning,
    arrivals,
  )
where

import Control.Monad (foldM, unless)
import Control.Monad.Trans.Except (runExceptT, throwE)
import qualified Control.Monad.Trans.State.Strict as State
import Data.Bifunctor (first)
import Data.List (partition)
import Data.Maybe (fromMaybe)
import Rosy.Model.Firing
import Rosy.Model.Program

-- ---------------------------------------------------------------------------------------------
-- A run

-- | What a program says, each at the time at which it says it. Time is counted in milliseconds. A program begins with the first thing
-- that happens.
meaning :: Program -> [(Int, Happening)] -> [(Int, Said)]
meaning program happenings = reverse (said (State.execState (runExceptT run >>= either over pure) world0))
  where
    world0 = World 0 Nothing [] [] 0 0 0 [] [] []
    run = case happenings of
      (t, h) : _ | isInstant h -> passTime t >> advance limit program >>= go happenings
      _ -> go happenings (Paused program)
    go days r = case (r, days) of
      (Returned _, _) -> throwE Finished
      (_, []) -> pure ()
      (_, (t, h) : rest) -> instant r t h >>= go rest

-- | Rule 11: whatever ended it, all live tasks clean up, then the robot is told to stop, and why comes last.
over :: Ending -> State.State World ()
over Lost = State.modify (\w -> w {said = (time w, Over Lost) : said w})
over ending = cleanUp >> State.modify (\w -> w {said = (time w, Over ending) : (time w, Halt) : said w})

-- | The youngest task first, each once. One that fails is passed over.
cleanUp :: State.State World ()
cleanUp = do
  left <- State.gets cleanups
  unless (null left) $ do
    let youngest = maximum (map fst left)
        (now, later) = partition ((== youngest) . fst) left
    State.modify (\w -> w {cleanups = later})
    mapM_ (runExceptT . atOnce youngest . snd) now
    cleanUp

-- | Rules 8 and 10: rounds of user events, and steps of one task, in one instant.
limit :: Int
limit = 64

-- ---------------------------------------------------------------------------------------------
-- Tasks (rule 10)

-- | What runs, up to a value.
data Running
  = Returned Value
  | Starting Int Live Spec (Value -> Program)
  | Giving Int Live Program
  | Working Int [Live] [Called] Spec (Value -> Program)
  | Waiting Int Program
  | Paused Program
  | Beside Running Running (Value -> Program)
  | Against Running Running (Value -> Program)

data Called = Called Running (Maybe Live) Calling

-- | Go on until something has to be waited for, or for so many steps.
advance :: Int -> Program -> Doing Running
advance left program = case program of
  Return v -> pure (Returned v)
  _ | left <= 0 -> pure (Paused program)
  Task spec k -> do
    scope <- newScope
    b <- gets emitted
    case start spec of
      Nothing -> install left scope b [] spec k
      Just f -> atOnce scope f >>= maybe (pure (Starting scope (live b f) spec k)) (\out -> install left scope b out spec k)
  Once f rest -> do
    scope <- newScope
    b <- gets emitted
    atOnce scope f >>= maybe (pure (Giving scope (live b f) rest)) (afterOnce left rest)
  Wait t rest -> do
    now <- gets time
    if t <= 0 then advance (left - 1) rest else pure (Waiting (now + t) rest)
  Both a b k -> do
    x <- advance (left - 1) a
    y <- advance (left - 1) b
    beside (left - 1) x y k
  First a b k -> do
    x <- advance (left - 1) a
    case x of
      Returned v -> advance (left - 1) (k (InLeft v))
      _ -> advance (left - 1) b >>= \y -> against (left - 1) x y k

-- | A command given once is no task: nothing may end there, and nothing may be called, for nobody stays to hear of it.
afterOnce :: Int -> Program -> [Given] -> Doing Running
afterOnce left rest outputs = do
  _ <- dones noType outputs
  case [who | Given who (Call _) <- outputs] of
    who : _ -> throwE (CalledInOnce who)
    [] -> advance (left - 1) rest

-- | A type that no value has.
noType :: Type
noType = ""

newScope :: Doing Int
newScope = do
  n <- gets scopes
  modify (\w -> w {scopes = n + 1})
  pure n

-- | The start has been carried out; now the controller lives. A function hears what was emitted since the task began.
install :: Int -> Int -> Int -> [Given] -> Spec -> (Value -> Program) -> Doing Running
install left scope b outputs spec k = do
  done <- dones (ends spec) outputs
  case done of
    v : _ -> advance (left - 1) (k v)
    [] -> do
      mapM_ (\f -> modify (\w -> w {cleanups = (scope, f) : cleanups w})) (stopped spec)
      calls <- begin (left - 1) scope outputs
      pure (Working scope (map (live b) (functions spec)) calls spec k)

beside :: Int -> Running -> Running -> (Value -> Program) -> Doing Running
beside left (Returned x) (Returned y) k = advance left (k (Tuple [x, y]))
beside _ x y k = pure (Beside x y k)

against :: Int -> Running -> Running -> (Value -> Program) -> Doing Running
against left x (Returned v) k = stop x >> advance left (k (InRight v))
against _ x y k = pure (Against x y k)

-- | Start what was called.
begin :: Int -> Int -> [Given] -> Doing [Called]
begin left scope outputs = concat <$> mapM one [c | Given _ (Call c) <- outputs]
  where
    one c = do
      outer <- takeFed
      b <- gets emitted
      r <- advance left (called c)
      fst <$> report scope outer (Called r (fmap (live b) (cancel c)) c)

takeFed :: Doing [Value]
takeFed = do
  vs <- gets fed
  modify (\w -> w {fed = []})
  pure vs

-- | Tell the caller about feedback and the end.
report :: Int -> [Value] -> Called -> Doing ([Called], [Given])
report scope outer c@(Called r _ calling) = do
  own <- takeFed
  modify (\w -> w {fed = outer})
  told <- mapM tell own
  case r of
    Returned v -> do
      out <- atOnce scope (response calling v)
      pure ([], concat told ++ fromMaybe [] out)
    _ -> pure ([c], concat told)
  where
    tell v = case feedback calling v of
      Nothing -> [] <$ modify (\w -> w {fed = fed w ++ [v]})
      Just f -> fromMaybe [] <$> atOnce scope f

-- | Stop all that is live in there, the called first, each clean-up once.
stop :: Running -> Doing ()
stop r = case r of
  Working scope _ calls _ _ -> do
    mapM_ (\(Called inner _ _) -> stop inner) calls
    takeCleanUp scope >>= mapM_ (atOnce scope)
  Beside a b _ -> stop a >> stop b
  Against a b _ -> stop a >> stop b
  _ -> pure ()

-- | What the task would do when it is stopped: now it does it, or never.
takeCleanUp :: Int -> Doing [Function]
takeCleanUp scope = do
  (now, later) <- gets (partition ((== scope) . fst) . cleanups)
  modify (\w -> w {cleanups = later})
  pure (map snd now)

-- | Let everything that runs notice, in the program's order.
deliver :: Occurrence -> Running -> Doing Running
deliver o r = case r of
  Returned _ -> pure r
  Starting scope l spec k -> do
    b <- gets emitted
    w <- get
    case due o w l of
      (a : _, _) -> fire scope (function l) a >>= \out -> install limit scope b out spec k
      ([], l') -> pure (Starting scope l' spec k)
  Giving scope l rest -> do
    w <- get
    case due o w l of
      (a : _, _) -> fire scope (function l) a >>= afterOnce limit rest
      ([], l') -> pure (Giving scope l' rest)
  Working scope lives calls spec k -> work scope o lives calls spec k
  Waiting t rest -> outside (gets time >>= \now -> if now >= t then advance limit rest else pure r)
  Paused rest -> outside (advance limit rest)
  Beside a b k -> do
    x <- deliver o a
    y <- deliver o b
    beside limit x y k
  Against a b k -> do
    x <- deliver o a
    case x of
      Returned v -> stop b >> advance limit (k (InLeft v))
      _ -> deliver o b >>= \y -> against limit x y k
  where
    outside act = case o of
      Outside _ -> act
      Inside {} -> pure r

-- | One task: its functions in order, then what they had called. The first 'Done' ends it.
work :: Int -> Occurrence -> [Live] -> [Called] -> Spec -> (Value -> Program) -> Doing Running
work scope o lives calls spec k = leaves lives [] []
  where
    leaves [] seen fresh = rest calls [] seen fresh
    leaves (l : ls) seen fresh = do
      (l', out) <- notice scope o l
      more <- begin limit scope out
      done <- dones (ends spec) out
      case done of
        v : _ -> finish v (calls ++ fresh ++ more)
        [] -> leaves ls (seen ++ [l']) (fresh ++ more)
    rest [] kept seen fresh = pure (Working scope seen (kept ++ fresh) spec k)
    rest (c@(Called inner canceller calling) : cs) kept seen fresh = do
      (canceller', out) <- case canceller of
        Nothing -> pure (Nothing, [])
        Just l -> first Just <$> notice scope o l
      if null out
        then do
          outer <- takeFed
          inner' <- deliver o inner
          (left, told) <- report scope outer (Called inner' canceller' calling)
          more <- begin limit scope told
          done <- dones (ends spec) told
          case done of
            v : _ -> finish v (kept ++ left ++ cs ++ fresh ++ more)
            [] -> rest cs (kept ++ left) seen (fresh ++ more)
        else do
          let Called running _ _ = c
          stop running
          rest cs kept seen fresh
    finish v others = do
      mapM_ (\(Called inner _ _) -> stop inner) others
      _ <- takeCleanUp scope
      advance (limit - 1) (k v)

-- ---------------------------------------------------------------------------------------------
-- Instants

-- | Whether it is about something that a program can notice.
isInstant :: Happening -> Bool
isInstant h = h `notElem` [Stop, Loss]

-- | One instant: what happens, then rounds of what was emitted (rule 8). Or the end, which takes no time of its own.
instant :: Running -> Int -> Happening -> Doing Running
instant r t h = case h of
  Stop -> throwE Stopped
  Loss -> throwE Lost
  _ -> do
    passTime t
    modify (\w -> w {fed = []})
    case h of
      Odometry v -> modify (\w -> w {odometry = Just v})
      _ -> pure ()
    deliver (Outside h) r >>= rounds limit

rounds :: Int -> Running -> Doing Running
rounds left r = case r of
  Returned _ -> pure r
  _ | left == 0 -> pure r
  _ -> do
    pending <- gets queue
    modify (\w -> w {queue = []})
    if null pending
      then pure r
      else foldM (\x (number, (ty, v)) -> deliver (Inside number ty v) x) r pending >>= rounds (left - 1)
