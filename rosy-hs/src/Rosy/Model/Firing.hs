-- |
-- Module      : Rosy.Model.Firing
-- Description : When a function fires, and what one firing does.
--
-- Rules R1 to R9 and R25 as pure code; what becomes of tasks is in "Rosy.Model". Two notions carry everything:
--
-- * An __arrival__ is a value that an input gets from one happening ('arrivals'). A function fires at each arrival of its input.
-- * A __turn__: an v'Either' has a turn for each of its sides, the left one first, so that a happening that
--   concerns both sides arrives twice. All members of an 'All' take their turns together.
module Rosy.Model.Firing
  ( -- * The state of the world
    World (..),
    Turning (..),
    turn,
    Doing,
    get,
    gets,
    modify,
    passTime,
    say,
    surroundedBy,
    release,
    forgetController,
    forgetSender,

    -- * Inputs
    Occurrence (..),
    Arrival,
    arrivals,

    -- * Functions
    Live (..),
    live,
    due,
    fire,
    Given (..),
    notice,
    dones,
    atOnce,
    causeOf,

    -- * What depends on what
    Sending (..),
    concerns,
    mightFire,
    mentionsState,
    turnOn,
    settlePhantoms,
  )
where

import Control.Monad (when)
import Control.Monad.Trans.Class (lift)
import Control.Monad.Trans.Except (ExceptT, throwE)
import qualified Control.Monad.Trans.State.Strict as State
import qualified Data.IntSet as IntSet
import Data.List (nub, sort)
import Data.Maybe (catMaybes, fromMaybe, isJust, isNothing)
import Rosy.Model.Program
import Rosy.Model.Relevance
import Prelude hiding (Read, reads)

-- ---------------------------------------------------------------------------------------------
-- The state of the world

-- | All that the program's past has left.
data World = World
  { time :: Int,
    -- | What odometry said last, and in which instant.
    odometry :: Maybe (Int, Int),
    -- | By scope and type, with the firing that wrote it. Params have scope 'paramScope'.
    memory :: [((Int, Type), (Value, Int))],
    -- | Emitted and not delivered.
    queue :: [(Sending, (Type, Value))],
    emitted :: Int,
    scopes :: Int,
    -- | How many random generators were read.
    chances :: Int,
    -- | Newest first.
    said :: [(Int, Said)],
    fed :: [Value],
    -- | What the live tasks do when they are stopped, by scope.
    cleanups :: [(Int, Function)],
    -- | The scope that commanded the velocity in force, unless that is 0.
    driver :: Maybe Int,
    -- | The arbiters that the commands of a new scope pass, those of each scope, and what each keeps for velocities and lights: since
    -- when and until when the first controller has the actuator, and the second one's latest command (rule R25).
    surrounding :: [Owned],
    inherited :: [(Int, [Owned])],
    holds :: [((Int, Int, Bool), (Maybe (Int, Int), Maybe (Int, [Owned], Output)))],
    -- | How many instants there were.
    instants :: Int,
    -- | Newest first.
    firings :: [Firing],
    -- | What the firing at work has read, newest first.
    taken :: [(Read, Value)],
    -- | The latest firing of each scope, and the latest that gave feedback.
    latest :: [(Int, Int)],
    latestFed :: Int,
    -- | What led to the latest change of tasks: the cause of what is carried out at once.
    turning :: Turning,
    -- | On what all this may depend (rule R12), the user events that might be under way in this instant, and all functions, with
    -- their number and scope.
    labels :: Labels,
    absent :: Phantoms,
    known :: [(Int, Int, Function)]
  }

-- | An arbiter with the scope in whose controller it stands.
type Owned = (Int, Arbiter)

-- | What leads to a change of tasks: the last three are what the latest firing in a scope gave, the latest feedback, and the end of the program.
data Turning = AtStart | InThisInstant | After Int | Feeding | AtEnd

-- | What changes the world, and may end the program.
type Doing = ExceptT Ending (State.State World)

-- | What is so now.
get :: Doing World
get = lift State.get

-- | A part of 'get'.
gets :: (World -> a) -> Doing a
gets = lift . State.gets

-- | From now on it is so.
modify :: (World -> World) -> Doing ()
modify = lift . State.modify

-- | From here on tasks begin and end because of this.
turn :: Turning -> Doing ()
turn what = modify (\w -> w {turning = what})

paramScope :: Int
paramScope = -1

-- | It is so many milliseconds now.
passTime :: Int -> Doing ()
passTime t = modify (\w -> w {time = t})

-- | Say something now.
say :: Said -> Doing ()
say what = modify (\w -> w {said = (time w, what) : said w})

-- ---------------------------------------------------------------------------------------------
-- Inputs

-- | Something a function may notice: a happening, or the value of a user event with its number and the firing that emitted it.
data Occurrence = Outside Happening | Inside Sending Type Value

-- | Of a user event: its number, the firing that emitted it, and on what it depends.
data Sending = Sending Int Int Label

-- | The value of an arrival, read in the task's scope when the function fires. 'needsState' arrivals wait for odometry (rule R5).
data Arrival = Arrival {needsState :: Bool, readIn :: Int -> Doing Value}

-- | What each occurrence of a history brings to an input, turn by turn.
arrivals :: Input -> [Occurrence] -> [[Maybe Arrival]]
arrivals i history = case i of
  Event t -> [[fmap (Arrival False . const . take' ReadEvent) (eventOf t o)] | o <- history]
  State -> [[if isOdometry o then Just (level State) else Nothing] | o <- history] -- rule R2, and rule R4 inside Either
  Either a b -> zipWith (++) (side InLeft a) (side InRight b) -- rule R4
  All members -> case flatten members of
    [] -> map (const [Nothing]) history
    inputs -> joined inputs history
  _ -> map (const [Nothing]) history -- rule R3
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

-- | Whether the input has values of its own in time: rules R1 to R4.
isEvent :: Input -> Bool
isEvent i = case i of
  Event _ -> True
  Either _ _ -> True
  All members -> any isEvent members
  _ -> False

-- | The current value of states and samples.
level :: Input -> Arrival
level i = case i of
  State -> Arrival True (\_ -> gets (fromMaybe (0, 0) . odometry) >>= \(v, instant) -> take' (ReadState instant) (Int v))
  Memory t -> Arrival False (\s -> recall (ReadMemory t) (s, t)) -- rule R7
  Param t -> Arrival False (\_ -> recall (ReadParam t) (paramScope, t))
  Time -> Arrival False (\_ -> gets (Int . time) >>= take' ReadTime)
  Clock -> Arrival False (\_ -> gets (Tuple . map Int . onTheClock . time) >>= take' ReadTime)
  Chance -> Arrival False (\_ -> gets chances >>= \n -> modify (\w -> w {chances = n + 1}) >> take' (ReadChance n) (Int n))
  All members -> Arrival (any (needsState . level) members) (\s -> Tuple <$> mapM ((`readIn` s) . level) (flatten members))
  _ -> Arrival False (\_ -> pure (Tuple []))
  where
    recall from key = gets (lookup key . memory) >>= maybe (take' (from Nothing) (Int 0)) (\(v, by) -> take' (from (Just by)) v)
    onTheClock t = [t `div` 3600000 `mod` 24, t `div` 60000 `mod` 60, t `div` 1000 `mod` 60, t `mod` 1000]

-- | A value, which the firing at work reads there.
take' :: Read -> Value -> Doing Value
take' from v = v <$ modify (\w -> w {taken = (from, v) : taken w})

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
data Live = Live {function :: Function, numbered :: Int, born :: Int, noticed :: [Occurrence], waits :: [Arrival]}

-- | A function begins to notice.
live :: Int -> Int -> Function -> Doing Live
live scope b f = do
  n <- gets (length . known)
  modify (\w -> w {known = (n, scope, f) : known w})
  pure (Live f n b [] [])

-- | What fires now, in order. An arrival that needs a state waits until there is one.
due :: Occurrence -> World -> Live -> ([Arrival], Live)
due o w l
  | Inside (Sending number _ _) _ _ <- o, number < born l = ([], l)
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

-- | One transaction: read, compute, write, all at once (rule R6). A function that fails has done nothing, not even read (rule R11).
fire :: Cause -> Label -> Int -> Function -> Arrival -> Doing [Given]
fire why label scope f a = do
  before <- get
  let needs = IntSet.unions (label : map (`labelOf` labels before) (readPlaces scope (input f)))
  modify (\w -> w {taken = []})
  v <- readIn a scope
  let outputs = body f v
  when (or [True | Fail <- outputs]) (modify (const before) >> throwE (Failed (name f)))
  say (Fired (name f))
  number <- gets (length . firings)
  modify (\w -> w {firings = Firing (time w) (name f) scope why (reverse (taken w)) outputs needs : firings w, latest = (scope, number) : filter ((/= scope) . fst) (latest w)})
  mapM_ (carryOut number needs) outputs
  mapM_ (mightGive needs scope) [o | o <- outlets f, not (any (o `isOutletOf`) outputs)]
  mightRead label f
  pure (map (Given (name f)) outputs)
  where
    carryOut number needs out = case out of
      Command v -> say (Commanded v) -- rule R9
      Drive _ -> passing [] out
      Light _ -> passing [] out
      Arbitrated _ (Call _) -> pure ()
      Arbitrated own o -> passing own o
      Write t v -> remember number needs (scope, t) v
      Share t v -> remember number needs (paramScope, t) v
      Emit t v -> modify (\w -> w {queue = queue w ++ [(Sending (emitted w) number needs, (t, v))], emitted = emitted w + 1})
      Feedback v -> modify (\w -> w {fed = fed w ++ [v], latestFed = number})
      _ -> pure ()
    passing own out = arbitersOf scope own >>= \arbiters' -> send scope arbiters' out
    remember number needs key@(s, t) v =
      modify (\w -> w {memory = (key, (v, number)) : filter ((/= key) . fst) (memory w), labels = replaceLabel (Remembered s t) needs (labels w)})

-- ---------------------------------------------------------------------------------------------
-- Priority (rule R25)

-- | These arbiters of a controller in this scope, and those around it.
arbitersOf :: Int -> [Arbiter] -> Doing [Owned]
arbitersOf scope own = gets (\w -> [(scope, a) | a <- own] ++ fromMaybe [] (lookup scope (inherited w)))

-- | The scopes that begin meanwhile have these arbiters of this scope around them.
surroundedBy :: Int -> [Arbiter] -> Doing a -> Doing a
surroundedBy scope own act = do
  before <- gets surrounding
  inside <- arbitersOf scope own
  modify (\w -> w {surrounding = inside})
  act <* modify (\w -> w {surrounding = before})

-- | A velocity or a light on its way through arbiters.
send :: Int -> [Owned] -> Output -> Doing ()
send scope arbiters' out = case arbiters' of
  [] -> actuate
  (owner, Arbiter n side) : outer -> do
    now <- gets time
    let key = (owner, n, isLight)
    (held, latest') <- gets (fromMaybe (Nothing, Nothing) . lookup key . holds)
    case side of
      Leads t -> keep key (Just (now, now + t), latest') >> send scope outer out
      Follows -> keep key (held, Just (scope, outer, out)) >> if maybe False (isHeldAt now) held then pure () else send scope outer out
  where
    isLight = case out of
      Light _ -> True
      _ -> False
    actuate = case out of
      Drive v -> say (Driven v) >> modify (\w -> w {driver = if v == 0 then Nothing else Just scope})
      Light v -> say (Lit v)
      _ -> pure ()

keep :: (Int, Int, Bool) -> (Maybe (Int, Int), Maybe (Int, [Owned], Output)) -> Doing ()
keep key hold = modify (\w -> w {holds = (key, hold) : filter ((/= key) . fst) (holds w)})

isHeldAt :: Int -> (Int, Int) -> Bool
isHeldAt now (since, until') = now == since || now < until'

-- | Where the time of the first controllers is over, the latest commands of the second ones hold again.
release :: Doing ()
release = gets (sort . map fst . holds) >>= mapM_ one
  where
    one key = do
      now <- gets time
      found <- gets (lookup key . holds)
      case found of
        Just (Just held, latest') | not (isHeldAt now held) -> do
          keep key (Nothing, latest')
          mapM_ (\(scope, outer, out) -> send scope outer out) latest'
        _ -> pure ()

-- | The controller of this scope is gone.
forgetController :: Int -> Doing ()
forgetController scope = modify (\w -> w {holds = [h | h@((owner, _, _), _) <- holds w, owner /= scope]})

-- | This scope was stopped: what it commanded does not hold again.
forgetSender :: Int -> Doing ()
forgetSender scope = modify (\w -> w {holds = map (fmap (fmap (\l -> case l of Just (sender, _, _) | sender == scope -> Nothing; _ -> l))) (holds w)})

-- | The cause of a firing whose inputs an occurrence completes.
causeOf :: Occurrence -> Doing Cause
causeOf o = case o of
  Outside _ -> gets (\w -> Occurred (instants w - 1))
  Inside (Sending number by _) _ _ -> pure (Received number by)

-- | An output, and the function that gave it.
data Given = Given String Output

-- | Fire all that is due, up to the first 'Done'.
notice :: Int -> Occurrence -> Live -> Doing (Live, [Given])
notice scope o l = do
  w <- get
  let (fires, l') = due o w l
  why <- causeOf o
  label <- concerns o l
  when (null fires) (mapM_ (mightFire scope (function l)) label)
  outputs <- untilDone why (fromMaybe IntSet.empty label) fires
  pure (l', outputs)
  where
    untilDone _ _ [] = pure []
    untilDone why label (a : as) = do
      outputs <- fire why label scope (function l) a
      if givesDone outputs then pure outputs else (outputs ++) <$> untilDone why label as

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
    else do
      why <- gets carried
      label <- gets (labelOf TaskTree . labels)
      Just <$> fire why label scope f (level (input f))
  where
    carried w = case turning w of
      AtStart -> Began
      InThisInstant -> Resumed (instants w - 1)
      After s -> maybe Began Followed (lookup s (latest w))
      Feeding -> Followed (latestFed w)
      AtEnd -> Ended

-- ---------------------------------------------------------------------------------------------
-- What depends on what (rule R12)

-- | All that an input may read.
readPlaces :: Int -> Input -> [Place]
readPlaces scope i = nub $ case i of
  State -> [Measured]
  Memory t -> [Remembered scope t]
  Param t -> [Remembered paramScope t]
  Chance -> [Generators]
  All members -> concatMap (readPlaces scope) members
  Either a b -> readPlaces scope a ++ readPlaces scope b
  _ -> []

-- | Whether an output is of this kind.
isOutletOf :: Outlet -> Output -> Bool
isOutletOf outlet out = case (outlet, out) of
  (MayWrite t, Write t' _) -> t == t'
  (MayShare t, Share t' _) -> t == t'
  (MayEmit t, Emit t' _) -> t == t'
  _ -> False

-- | A function might have given this with another input.
mightGive :: Label -> Int -> Outlet -> Doing ()
mightGive label scope outlet = case outlet of
  MayWrite t -> depend (Remembered scope t) label
  MayShare t -> depend (Remembered paramScope t) label
  MayEmit t -> modify (\w -> w {absent = addPhantom t label (absent w)})
  MayTurn -> turnOn label

-- | A function that did not fire might have fired.
mightFire :: Int -> Function -> Label -> Doing ()
mightFire scope f label = mapM_ (mightGive label scope) (outlets f) >> mightRead label f

-- | A function might read, and use up, a random generator.
mightRead :: Label -> Function -> Doing ()
mightRead label f = mapM_ (`depend` label) [Generators | Generators <- readPlaces 0 (input f)]

-- | From now on a place depends on this as well.
depend :: Place -> Label -> Doing ()
depend place label = modify (\w -> w {labels = addLabel place label (labels w)})

-- | From now on it depends on this which tasks live.
turnOn :: Label -> Doing ()
turnOn = depend TaskTree

-- | On what it depends whether a function fires at an occurrence; nothing if the occurrence does not concern it. All that it may give then
-- depends on that.
concerns :: Occurrence -> Live -> Doing (Maybe Label)
concerns o l = do
  w <- get
  let f = function l
      i = input f
      ofOccurrence = case o of
        Outside _ -> IntSet.singleton (instants w - 1)
        Inside (Sending _ _ found) _ _ -> found
      keeps = Kept (numbered l)
      base = IntSet.unions ([labelOf TaskTree (labels w), labelOf keeps (labels w)] ++ [labelOf FirstMeasured (labels w) | isEvent i, mentionsState i])
      triggered = not (null [() | isEvent i || isState i, Just _ <- concat (arrivals (openly i) [o])]) || (not (isEvent i || isState i) && isTick o)
      released = isEvent i && mentionsState i && isOdometry o
      label
        | triggered = Just (IntSet.union ofOccurrence base)
        | released = Just base
        | otherwise = Nothing
  case label of
    Nothing -> pure ()
    Just found -> do
      when (triggered && keepsNow w i) (depend keeps found)
  pure label
  where
    isTick (Outside Tick) = True
    isTick _ = False
    -- Any part of an input that keeps values is concerned as soon as one of its parts is.
    openly i = case i of
      All members | isEvent i -> foldr (Either . openly) (Event "nothing") (filter isEvent (flatten members))
      Either a b -> Either (openly a) (openly b)
      other -> other

-- | Whether an input reads the state anywhere.
mentionsState :: Input -> Bool
mentionsState i = Measured `elem` readPlaces 0 i

-- | Whether an input keeps values now: until their partners come, or the first state.
keepsNow :: World -> Input -> Bool
keepsNow w i = isKeeping i || (mentionsState i && isNothing (odometry w))

-- | Whether an input keeps values until their partners come.
isKeeping :: Input -> Bool
isKeeping i = case i of
  All members -> length (filter isEvent (flatten members)) > 1 || any isKeeping members
  Either a b -> isKeeping a || isKeeping b
  _ -> False

-- | What functions would do with the events that might be under way.
settlePhantoms :: Doing ()
settlePhantoms = do
  before <- gets absent
  mapM_ reach (phantoms before)
  after <- gets absent
  if before == after then pure () else settlePhantoms
  where
    reach (t, label) = do
      functions' <- gets known
      mapM_ (reached label) [k | k@(_, _, f) <- functions', t `elem` eventsOf (input f)]
    reached label (n, scope, f) = do
      w <- get
      when (keepsNow w (input f)) (depend (Kept n) label)
      mightFire scope f label
    eventsOf i = case i of
      Event t -> [t]
      All members -> concatMap eventsOf members
      Either a b -> eventsOf a ++ eventsOf b
      _ -> []
