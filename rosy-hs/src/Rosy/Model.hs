-- |
-- Module      : Rosy.Model
-- Description : What a program means: timed happenings in, timed firings and commands out.
--
-- This is LANGUAGE.md section 2 once more, as code that cares for nothing but being right: lists, no threads, no I/O,
-- no cleverness. Where the page and the runtime ("Rosy.Loop") disagree with it, it is they who are wrong; the tests
-- compare the runtime with 'meaning' on generated programs and happenings.
--
-- The model is untyped: a type is a name, a value is a small tree, a function is its input, its name and what it gives.
--
-- Two notions carry everything:
--
-- * An __arrival__ is a value that an input gets from one happening ('arrivals'). A function fires at each arrival of its input.
-- * A __turn__: an v'Either' has a turn for each of its sides, the left one first, so that a happening that
--   concerns both sides arrives twice. All members of an 'All' take their turns together.
--
-- A third one ends everything: an __ending__ ('Ending') stops whatever is going on at once, and only clean-ups follow it (rule 11).
module Rosy.Model
  ( -- * Programs
    Program (..),
    Spec (..),
    Function (..),
    Calling (..),
    Input (..),
    Output (..),
    Value (..),
    Type,

    -- * Time
    Happening (..),
    Said (..),
    Ending (..),

    -- * Meaning
    meaning,
    arrivals,
  )
where

import Control.Monad (foldM, unless, when)
import Control.Monad.Trans.Class (lift)
import Control.Monad.Trans.Except (ExceptT, runExceptT, throwE)
import qualified Control.Monad.Trans.State.Strict as State
import Data.Bifunctor (first)
import Data.List (partition)
import Data.Maybe (catMaybes, fromMaybe, isJust)

-- ---------------------------------------------------------------------------------------------
-- Programs

-- | The name of a type.
type Type = String

-- | Enough values to tell things apart.
data Value = Int Int | InLeft Value | InRight Value | Tuple [Value]
  deriving (Eq, Ord, Show, Read)

-- | What a function takes.
data Input
  = -- | Every message or emitted value of the type. The tick is the event @"()"@.
    Event Type
  | -- | What odometry said last.
    State
  | -- | The memory of the task, of a type.
    Memory Type
  | -- | The memory of the program, of a type.
    Param Type
  | -- | The time, in milliseconds.
    Time
  | -- | The time as hours, minutes, seconds and milliseconds, round the clock.
    Clock
  | -- | A random generator of its own: the first one of the program is 0, the next one 1.
    Chance
  | -- | All of these: curried arguments, tuples.
    All [Input]
  | -- | Either, as it comes. @Maybe a@ is @Either a (Event "()")@.
    Either Input Input
  deriving (Eq, Show)

-- | What a function gives.
data Output
  = Command Value
  | Write Type Value
  | Share Type Value
  | Emit Type Value
  | -- | The type is that of the value.
    Done Type Value
  | Feedback Value
  | Call Calling
  | -- | Something that cannot be computed.
    Fail

-- | A function of the program.
data Function = Function
  { name :: String,
    input :: Input,
    body :: Value -> [Output]
  }

-- | Tasks in sequence and side by side, up to the value at the end.
data Program
  = Return Value
  | Task Spec (Value -> Program)
  | Once Function Program
  | Wait Int Program
  | Both Program Program (Value -> Program)
  | First Program Program (Value -> Program)

-- | A task. A controller outside tasks is one without a start, and of a type that no 'Done' has.
data Spec = Spec
  { -- | The type of the value that it ends with.
    ends :: Type,
    start :: Maybe Function,
    functions :: [Function],
    stopped :: Maybe Function
  }

-- | A task that is started beside its caller.
data Calling = Calling
  { called :: Program,
    -- | Gives any output to cancel.
    cancel :: Maybe Function,
    feedback :: Value -> Maybe Function,
    response :: Value -> Function
  }

-- ---------------------------------------------------------------------------------------------
-- Time

-- | What an instant is about. Rule 1 calls the first an event; odometry refreshes the state. The last two come from outside, between
-- two instants: the program is told to stop, and the connection to the robot is lost.
data Happening = Happens Type Value | Odometry Int | Tick | Stop | Loss
  deriving (Eq, Show)

-- | What is heard of a program: 'Halt' is the command to stand still.
data Said = Fired String | Commanded Value | Halt | Over Ending
  deriving (Eq, Show)

-- | How a program ends. Two ways name the function that is to blame.
data Ending
  = Finished
  | Stopped
  | -- | Nobody hears the program any more. What stands between it and the robot must tell the robot to stop.
    Lost
  | Failed String
  | -- | It gave a 'Done' of another type than its task's.
    EndedWrongly String
  deriving (Eq, Show)

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

-- ---------------------------------------------------------------------------------------------
-- The state of the world

data World = World
  { time :: Int,
    odometry :: Maybe Int,
    -- | By scope and type. Params have scope 'paramScope'.
    memory :: [((Int, Type), Value)],
    -- | Emitted and not delivered, each with its number.
    queue :: [(Int, (Type, Value))],
    emitted :: Int,
    scopes :: Int,
    -- | How many random generators were read.
    chances :: Int,
    -- | Newest first.
    said :: [(Int, Said)],
    fed :: [Value],
    -- | What the live tasks do when they are stopped, by scope.
    cleanups :: [(Int, Function)]
  }

-- | What changes the world, and may end the program.
type Doing = ExceptT Ending (State.State World)

get :: Doing World
get = lift State.get

gets :: (World -> a) -> Doing a
gets = lift . State.gets

modify :: (World -> World) -> Doing ()
modify = lift . State.modify

paramScope :: Int
paramScope = -1

-- | Rules 8 and 10: rounds of user events, and steps of one task, in one instant.
limit :: Int
limit = 64

passTime :: Int -> Doing ()
passTime t = modify (\w -> w {time = t})

say :: Said -> Doing ()
say what = modify (\w -> w {said = (time w, what) : said w})

-- ---------------------------------------------------------------------------------------------
-- Inputs

-- | Something a function may notice: a happening, or the value of a user event with its number.
data Occurrence = Outside Happening | Inside Int Type Value

-- | The value of an arrival, read in the task's scope when the function fires. 'needsState' arrivals wait for odometry (rule 5).
data Arrival = Arrival {needsState :: Bool, readIn :: Int -> Doing Value}

-- | What each occurrence of a history brings to an input, turn by turn.
arrivals :: Input -> [Occurrence] -> [[Maybe Arrival]]
arrivals i history = case i of
  Event t -> [[fmap (Arrival False . const . pure) (eventOf t o)] | o <- history]
  State -> [[if isOdometry o then Just (level State) else Nothing] | o <- history] -- rule 2, and rule 4 inside Either
  Either a b -> zipWith (++) (side InLeft a) (side InRight b) -- rule 4
  All members -> case flatten members of
    [] -> map (const [Nothing]) history
    inputs -> joined inputs history
  _ -> map (const [Nothing]) history -- rule 3
  where
    side f = map (map (fmap (\a -> a {readIn = fmap f . readIn a}))) . (`arrivals` history)

-- | All of these: once every event has an unused value; it takes the newest of each. Members without events are read.
joined :: [Input] -> [Occurrence] -> [[Maybe Arrival]]
joined members history = go (map (const Nothing) events) rows
  where
    events = filter isEvent members
    rows = map padded (transposed (map (`arrivals` history) (if null events then members else events)))
    padded columns = let n = maximum (1 : map length columns) in [map (at k) columns | k <- [0 .. n - 1]]
    at k column = if k < length column then column !! k else Nothing
    go _ [] = []
    go unused (turnsOf : rest) = let (unused', out) = turns unused turnsOf in out : go unused' rest
    turns unused [] = (unused, [])
    turns unused (row : more)
      | null events = fmap ((if null [() | Just _ <- row] then Nothing else Just (level (All members))) :) (turns unused more)
      | otherwise =
        let newest = zipWith newer row unused
         in case sequence newest of
              Just values -> fmap (Just (together values) :) (turns (map (const Nothing) unused) more)
              Nothing -> fmap (Nothing :) (turns newest more)
    newer (Just new) _ = Just new
    newer Nothing old = old
    together values = Arrival (any needsState parts) (\s -> Tuple <$> mapM (`readIn` s) parts)
      where
        parts = merge members values
    merge (m : ms) values
      | isEvent m, v : vs <- values = v : merge ms vs
      | otherwise = level m : merge ms values
    merge [] _ = []

-- | The history of each member, per occurrence.
transposed :: [[a]] -> [[a]]
transposed columns
  | any null columns = []
  | otherwise = map head columns : transposed (map tail columns)

-- | An 'All' in an 'All' is one 'All'.
flatten :: [Input] -> [Input]
flatten = concatMap (\i -> case i of All inner -> flatten inner; _ -> [i])

-- | Whether the input has values of its own in time: rules 1 to 4.
isEvent :: Input -> Bool
isEvent i = case i of
  Event _ -> True
  Either _ _ -> True
  All members -> any isEvent members
  _ -> False

-- | The current value of states and samples.
level :: Input -> Arrival
level i = case i of
  State -> Arrival True (\_ -> gets (Int . fromMaybe 0 . odometry))
  Memory t -> Arrival False (\s -> recall (s, t)) -- rule 7
  Param t -> Arrival False (\_ -> recall (paramScope, t))
  Time -> Arrival False (\_ -> gets (Int . time))
  Clock -> Arrival False (\_ -> gets (Tuple . map Int . onTheClock . time))
  Chance -> Arrival False (\_ -> Int <$> gets chances <* modify (\w -> w {chances = chances w + 1}))
  All members -> Arrival (any (needsState . level) members) (\s -> Tuple <$> mapM ((`readIn` s) . level) (flatten members))
  _ -> Arrival False (\_ -> pure (Tuple []))
  where
    recall key = gets (fromMaybe (Int 0) . lookup key . memory)
    onTheClock t = [t `div` 3600000 `mod` 24, t `div` 60000 `mod` 60, t `div` 1000 `mod` 60, t `mod` 1000]

-- | Whether a level is refreshed by odometry.
isState :: Input -> Bool
isState = needsState . level

eventOf :: Type -> Occurrence -> Maybe Value
eventOf t o = case o of
  Outside (Happens t' v) | t == t' -> Just v
  Outside Tick | t == "()" -> Just (Tuple [])
  Inside _ t' v | t == t' -> Just v
  _ -> Nothing

isOdometry :: Occurrence -> Bool
isOdometry (Outside (Odometry _)) = True
isOdometry _ = False

-- ---------------------------------------------------------------------------------------------
-- Functions

-- | A function with all that it could notice since it was born, newest first.
data Live = Live {function :: Function, born :: Int, noticed :: [Occurrence], waits :: [Arrival]}

-- | A function begins to notice.
live :: Int -> Function -> Live
live b f = Live f b [] []

-- | What fires now, in order. An arrival that needs a state waits until there is one.
due :: Occurrence -> World -> Live -> ([Arrival], Live)
due o w l
  | Inside number _ _ <- o, number < born l = ([], l)
  | hasState = (waits l ++ new, l' {waits = []})
  | otherwise = ([a | a <- new, not (needsState a)], l' {waits = waits l ++ [a | a <- new, needsState a]})
  where
    hasState = isJust (odometry w)
    l' = l {noticed = o : noticed l}
    i = case input (function l) of
      All members -> All (flatten members)
      other -> other
    new
      | isEvent i || isState i = catMaybes (last (arrivals i (reverse (noticed l'))))
      | Outside Tick <- o = [level i]
      | otherwise = []

-- | One transaction: read, compute, write, all at once (rule 6). A function that fails has done nothing, not even read (rule 11).
fire :: Int -> Function -> Arrival -> Doing [Given]
fire scope f a = do
  before <- get
  v <- readIn a scope
  let outputs = body f v
  when (or [True | Fail <- outputs]) (modify (const before) >> throwE (Failed (name f)))
  say (Fired (name f))
  mapM_ carryOut outputs
  pure (map (Given (name f)) outputs)
  where
    carryOut out = case out of
      Command v -> say (Commanded v) -- rule 9
      Write t v -> remember (scope, t) v
      Share t v -> remember (paramScope, t) v
      Emit t v -> modify (\w -> w {queue = queue w ++ [(emitted w, (t, v))], emitted = emitted w + 1})
      Feedback v -> modify (\w -> w {fed = fed w ++ [v]})
      _ -> pure ()
    remember key v = modify (\w -> w {memory = (key, v) : filter ((/= key) . fst) (memory w)})

-- | An output, and the function that gave it.
data Given = Given String Output

-- | Fire all that is due, up to the first 'Done'.
notice :: Int -> Occurrence -> Live -> Doing (Live, [Given])
notice scope o l = do
  w <- get
  let (fires, l') = due o w l
  outputs <- untilDone fires
  pure (l', outputs)
  where
    untilDone [] = pure []
    untilDone (a : as) = do
      outputs <- fire scope (function l) a
      if givesDone outputs then pure outputs else (outputs ++) <$> untilDone as

-- | The values that end a task of this type, if the first 'Done' fits it.
dones :: Type -> [Given] -> Doing [Value]
dones t outputs = case [(who, t', v) | Given who (Done t' v) <- outputs] of
  [] -> pure []
  (who, t', v) : _
    | t' == t -> pure [v]
    | otherwise -> throwE (EndedWrongly who)

givesDone :: [Given] -> Bool
givesDone outputs = or [True | Given _ (Done _ _) <- outputs]

-- | Fire if nothing has to be waited for.
atOnce :: Int -> Function -> Doing (Maybe [Given])
atOnce scope f = do
  arrived <- gets (isJust . odometry)
  if isEvent (input f) || (isState (input f) && not arrived)
    then pure Nothing
    else Just <$> fire scope f (level (input f))

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

-- | A command given once is no task: nothing may end there, and what it calls has nobody to call it.
afterOnce :: Int -> Program -> [Given] -> Doing Running
afterOnce left rest outputs = dones noType outputs >> advance (left - 1) rest

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
