-- |
-- Module      : Rosy.Model
-- Description : What a program means: timed happenings in, timed firings and commands out.
--
-- Executable form of rules R1 to R11 and R25 of rosy-hs/LANGUAGE.md: lists, no threads, no I/O, no optimisation. It is authoritative:
-- where the text or the runtime ("Rosy.Loop") disagrees with it, they are corrected. The tests compare the runtime
-- with 'meaning' on generated programs and happenings.
--
-- Read "Rosy.Model.Program" first: what a program is. Then "Rosy.Model.Firing": when a function fires, and what one firing does
-- (rules R1 to R9 and R25). Here functions become tasks, and tasks a run (rules R8, R10 and R11).
-- "Rosy.Model.Default" gives the first value of a memory of a declared type (rule R7); the memories of the model itself hold numbers.
--
-- An __ending__ ('Ending') stops whatever is going on at once, and only clean-ups follow it (rule R11).
module Rosy.Model
  ( -- * Programs, and time
    module Rosy.Model.Program,

    -- * Meaning
    meaning,
    provenance,
    arrivals,

    -- * Defaults of declared types
    module Rosy.Model.Default,
  )
where

import Control.Monad (foldM, unless, when)
import Control.Monad.Trans.Except (runExceptT, throwE)
import qualified Control.Monad.Trans.State.Strict as State
import Data.Bifunctor (first)
import qualified Data.IntSet as IntSet
import Data.List (partition)
import Data.Maybe (fromMaybe, isNothing)
import Rosy.Model.Default
import Rosy.Model.Firing
import Rosy.Model.Program
import Rosy.Model.Relevance

-- ---------------------------------------------------------------------------------------------
-- A run

-- | What a program says, each at the time at which it says it. Time is counted in milliseconds. A program begins with the first thing
-- that happens.
meaning :: Program -> [(Int, Happening)] -> [(Int, Said)]
meaning program happenings = reverse (said (final program happenings))

-- | Rule R12: all firings of a run, in order, each with its cause, what it read and what it gave.
provenance :: Program -> [(Int, Happening)] -> [Firing]
provenance program happenings = reverse (firings (final program happenings))

-- | All that is so after the run.
final :: Program -> [(Int, Happening)] -> World
final program happenings = State.execState (runExceptT run >>= either over pure) world0
  where
    world0 = World 0 Nothing [] [] 0 0 0 [] [] [] Nothing [] [] [] 0 [] [] [] 0 AtStart (addLabel TaskTree (IntSet.singleton 0) noLabels) noPhantoms []
    run = case happenings of
      (t, h) : _ | isInstant h -> passTime t >> advance limit program >>= go happenings
      _ -> go happenings (Paused program)
    go days r = case (r, days) of
      (Returned _, _) -> throwE Finished
      (_, []) -> pure ()
      (_, (t, h) : rest) -> instant r t h >>= go rest

-- | Rule R11: whatever ended it, all live tasks clean up, then the robot is told to stop, and why comes last.
over :: Ending -> State.State World ()
over Lost = State.modify (\w -> w {said = (time w, Over Lost) : said w})
over ending = cleanUp >> State.modify (\w -> w {said = (time w, Over ending) : (time w, Driven 0) : said w})

-- | The youngest task first, each once. One that fails is passed over.
cleanUp :: State.State World ()
cleanUp = do
  left <- State.gets cleanups
  unless (null left) $ do
    let youngest = maximum (map fst left)
        (now, later) = partition ((== youngest) . fst) left
    State.modify (\w -> w {cleanups = later, turning = AtEnd})
    mapM_ (runExceptT . atOnce youngest . snd) now
    cleanUp

-- | Rules R8 and R10: rounds of user events, and steps of one task, in one instant.
limit :: Int
limit = 64

-- ---------------------------------------------------------------------------------------------
-- Tasks (rule R10)

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
      Just f -> do
        startsNow f
        atOnce scope f >>= maybe ((\l -> Starting scope l spec k) <$> live scope b (turning' f)) (\out -> turn (After scope) >> install left scope b out spec k)
  Once f rest -> do
    scope <- newScope
    b <- gets emitted
    startsNow f
    atOnce scope f >>= maybe ((\l -> Giving scope l rest) <$> live scope b (turning' f)) (afterOnce scope left rest)
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

-- | A command given once is no task: nothing may end there, and nothing may be called, for nothing stays to hear of it.
afterOnce :: Int -> Int -> Program -> [Given] -> Doing Running
afterOnce scope left rest outputs = do
  turn (After scope)
  _ <- dones noType outputs
  case [who | given@(Given who _) <- outputs, not (null (callsIn [given]))] of
    who : _ -> throwE (CalledInOnce who)
    [] -> advance (left - 1) rest

-- | A type that no value has.
noType :: Type
noType = ""

-- | A function of which it depends whether it fires which tasks live: a start, or what cancels a task.
turning' :: Function -> Function
turning' f = f {outlets = MayTurn : outlets f}

-- | Whether a start is carried out at once depends on the state that it reads.
startsNow :: Function -> Doing ()
startsNow f = when (mentionsState (input f)) (gets (labelOf Measured . labels) >>= turnOn)

newScope :: Doing Int
newScope = do
  n <- gets scopes
  modify (\w -> w {scopes = n + 1, inherited = (n, surrounding w) : inherited w})
  pure n

-- | The start has been carried out; now the controller lives. A function hears what was emitted since the task began.
install :: Int -> Int -> Int -> [Given] -> Spec -> (Value -> Program) -> Doing Running
install left scope b outputs spec k = do
  done <- dones (ends spec) outputs
  case done of
    v : _ -> advance (left - 1) (k v)
    [] -> do
      mapM_ (\f -> modify (\w -> w {cleanups = (scope, f) : cleanups w})) (stopped spec)
      calls <- begin (left - 1) scope (callsIn outputs ++ tasks spec)
      lives <- mapM (live scope b) (functions spec)
      pure (Working scope lives calls spec k)

beside :: Int -> Running -> Running -> (Value -> Program) -> Doing Running
beside left (Returned x) (Returned y) k = advance left (k (Tuple [x, y]))
beside _ x y k = pure (Beside x y k)

against :: Int -> Running -> Running -> (Value -> Program) -> Doing Running
against left x (Returned v) k = stop x >> advance left (k (InRight v))
against _ x y k = pure (Against x y k)

-- | The tasks that were called.
callsIn :: [Given] -> [Calling]
callsIn = concatMap called'
  where
    called' (Given _ out) = case out of
      Call c -> [c]
      Arbitrated own (Call c) -> [c {arbiters = arbiters c ++ own}]
      _ -> []

-- | Start tasks beside the caller.
begin :: Int -> Int -> [Calling] -> Doing [Called]
begin left scope callings = do
  because <- gets turning
  concat <$> mapM (\c -> turn because >> one c) callings
  where
    one c = do
      outer <- takeFed
      b <- gets emitted
      r <- surroundedBy scope (arbiters c) (advance left (called c))
      canceller <- traverse (live scope b . turning') (cancel c)
      fst <$> report scope outer (Called r canceller c)

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
  because <- gets turning
  told <- mapM tell own
  case r of
    Returned v -> do
      turn because
      out <- atOnce scope (inside (response calling v))
      pure ([], concat told ++ fromMaybe [] out)
    _ -> pure ([c], concat told)
  where
    tell v = case feedback calling v of
      Nothing -> [] <$ modify (\w -> w {fed = fed w ++ [v]})
      Just f -> turn Feeding >> fromMaybe [] <$> atOnce scope (inside f)
    inside f = foldl (flip arbitrated) f (arbiters calling)

-- | Stop all that is live in there, the called first, each clean-up once.
stop :: Running -> Doing ()
stop r = case r of
  Working scope _ calls _ _ -> do
    mapM_ (\(Called inner _ _) -> stop inner) calls
    takeCleanUp scope >>= mapM_ (atOnce scope)
    standStill scope
    forgetSender scope
    forgetController scope
  Beside a b _ -> stop a >> stop b
  Against a b _ -> stop a >> stop b
  _ -> pure ()

-- | The robot stands if a function of this task set it in motion last.
standStill :: Int -> Doing ()
standStill scope = do
  d <- gets driver
  when (d == Just scope) (say (Driven 0) >> modify (\w -> w {driver = Nothing}))

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
      (a : _, _) -> first' scope l a >>= \out -> turn (After scope) >> install limit scope b out spec k
      ([], l') -> waiting scope l >> pure (Starting scope l' spec k)
  Giving scope l rest -> do
    w <- get
    case due o w l of
      (a : _, _) -> first' scope l a >>= afterOnce scope limit rest
      ([], l') -> waiting scope l >> pure (Giving scope l' rest)
  Working scope lives calls spec k -> work scope o lives calls spec k
  Waiting t rest -> outside (gets time >>= \now -> if now >= t then released >> advance limit rest else pure r)
  Paused rest -> outside (released >> advance limit rest)
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
    -- A function whose firing is the next step of its task.
    first' scope l a = do
      why <- causeOf o
      label <- fromMaybe IntSet.empty <$> concerns o l
      fire why label scope (function l) a
    waiting scope l = concerns o l >>= mapM_ (mightFire scope (function l))
    released = do
      turn InThisInstant
      now <- gets instants
      turnOn (IntSet.singleton (now - 1))
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
      more <- startCalled out
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
          inner' <- surroundedBy scope (arbiters calling) (deliver o inner)
          (left, told) <- report scope outer (Called inner' canceller' calling)
          more <- startCalled told
          done <- dones (ends spec) told
          case done of
            v : _ -> finish v (kept ++ left ++ cs ++ fresh ++ more)
            [] -> rest cs (kept ++ left) seen (fresh ++ more)
        else do
          let Called running _ _ = c
          turn (After scope)
          stop running
          rest cs kept seen fresh
    startCalled outputs = case callsIn outputs of
      [] -> pure []
      found -> turn (After scope) >> begin limit scope found
    finish v others = do
      turn (After scope)
      mapM_ (\(Called inner _ _) -> stop inner) others
      _ <- takeCleanUp scope
      forgetController scope
      advance (limit - 1) (k v)

-- ---------------------------------------------------------------------------------------------
-- Instants

-- | Whether it is about something that a program can notice.
isInstant :: Happening -> Bool
isInstant h = h `notElem` [Stop, Loss]

-- | One instant: what happens, then rounds of what was emitted (rule R8). Or the end, which takes no time of its own.
instant :: Running -> Int -> Happening -> Doing Running
instant r t h = case h of
  Stop -> throwE Stopped
  Loss -> throwE Lost
  _ -> do
    passTime t
    modify (\w -> w {fed = []})
    modify (\w -> w {instants = instants w + 1})
    case h of
      Odometry v -> modify (measured v)
      _ -> pure ()
    release
    deliver (Outside h) r >>= rounds limit >>= \r' -> r' <$ modify (\w -> w {absent = noPhantoms})
  where
    measured v w =
      let now = IntSet.singleton (instants w - 1)
          first' = if isNothing (odometry w) then addLabel FirstMeasured now else id
       in w {odometry = Just (v, instants w - 1), labels = first' (replaceLabel Measured now (labels w))}

rounds :: Int -> Running -> Doing Running
rounds left r = case r of
  Returned _ -> pure r
  _ | left == 0 -> pure r
  _ -> do
    settlePhantoms
    pending <- gets queue
    modify (\w -> w {queue = []})
    if null pending
      then pure r
      else foldM (\x (sending, (ty, v)) -> deliver (Inside sending ty v) x <* settlePhantoms) r pending >>= rounds (left - 1)
