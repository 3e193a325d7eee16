-- |
-- Module      : Rosy.Model.Firing
-- Description : When a function fires, and what one firing does.
--
-- Rules 1 to 9 as pure code; what becomes of tasks is in "Rosy.Model". Two notions carry everything:
--
-- * An __arrival__ is a value that an input gets from one happening ('arrivals'). A function fires at each arrival of its input.
-- * A __turn__: an v'Either' has a turn for each of its sides, the left one first, so that a happening that
--   concerns both sides arrives twice. All members of an 'All' take their turns together.
module Rosy.Model.Firing
  ( -- * The state of the world
    World (..),
    Doing,
    get,
    gets,
    modify,
    passTime,

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
  )
where

import Control.Monad (when)
import Control.Monad.Trans.Class (lift)
import Control.Monad.Trans.Except (ExceptT, throwE)
import qualified Control.Monad.Trans.State.Strict as State
import Data.Maybe (catMaybes, fromMaybe, isJust)
import Rosy.Model.Program

-- ---------------------------------------------------------------------------------------------
-- The state of the world

-- | All that the program's past has left.
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

-- | What is so now.
get :: Doing World
get = lift State.get

-- | A part of 'get'.
gets :: (World -> a) -> Doing a
gets = lift . State.gets

-- | From now on it is so.
modify :: (World -> World) -> Doing ()
modify = lift . State.modify

paramScope :: Int
paramScope = -1

-- | It is so many milliseconds now.
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
