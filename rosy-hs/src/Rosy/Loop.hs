{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE ExistentialQuantification #-}
{-# LANGUAGE RankNTypes #-}

-- |
-- Module      : Rosy.Loop
-- Description : One deterministic loop: a network and an instant in, firings and commands and the next network out.
--
-- The rules are those of LANGUAGE.md section 2; "Rosy.Model" says them again without any care for speed, and is right in doubt.
-- Everything here is pure. A step comes out as a 'Turn': a chain of firings whose effects are not computed yet, so that
-- whoever drives the loop ("Rosy.Run") can say which function is at work, and catch what it throws, before going on.
module Rosy.Loop
  ( -- * What it is
    Network,
    Turn (..),
    Firing (..),
    Outcome (..),

    -- * Running one
    Start (..),
    begin,
    What (..),
    instant,
    stop,

    -- * What came of it
    Report (..),
    collect,
    remembered,

    -- * Limits
    roundLimit,
    stepLimit,
  )
where

import Data.Bits ((.|.))
import Data.Dynamic (Dynamic, dynTypeRep, fromDynamic, toDyn)
import Data.IntMap.Strict (IntMap)
import qualified Data.IntMap.Strict as IntMap
import qualified Data.Map.Strict as Map
import Rosy.Core
import Rosy.Value (shown)
import System.Random (StdGen)

-- | The most rounds of user events in one instant (rule 8); what is pending then waits for the next instant.
roundLimit :: Int
roundLimit = 64

-- | The most steps that one task takes in one instant: tasks begun, commands given with @once@.
-- A choice of ours, equal to 'roundLimit' and for the same reason: every instant ends.
stepLimit :: Int
stepLimit = 64

-- ---------------------------------------------------------------------------------------------
-- What comes out

-- | One step, firing by firing.
data Turn
  = -- | A function is about to fire. Once its effects are computed, this is what follows.
    Fires Firing Turn
  | -- | The step is over; the program waits for the next.
    Settled !Network
  | -- | The program has ended.
    Ended !Outcome !Report

-- | A function at work.
data Firing = Firing
  { firingName :: !FunctionName,
    -- | What it was given, as Haskell shows it. Computed only when something asks.
    firingInputs :: [String],
    -- | Evaluating this is the firing. It throws what the function throws.
    firingEffects :: Effects,
    -- | What follows when it threw: the clean-up of all live tasks, then 'Ended'.
    firingFailed :: Turn
  }

-- | How a program ends by itself or is ended.
data Outcome
  = Finished
  | Stopped
  | Failed
  | -- | A function gave a 'Rosy.Done' of another type than the task's: the function, the type, the task's type.
    EndedWrongly String String String
  deriving (Eq, Show)

-- | What a step leaves for the outside, in order.
data Report = Report
  { reportActions :: [Action],
    -- | Events sensed and emitted, as Haskell shows them.
    reportEvents :: [String]
  }

-- ---------------------------------------------------------------------------------------------
-- The state

-- | All that is running.
data Network = forall r. Network !(Running r) !World

-- | The state that all parts share.
data World = World
  { env :: !Env,
    -- | Emitted and not yet delivered, newest first.
    queue :: ![Event],
    emitted :: !Int,
    -- | Newest first; so are the events heard.
    actions :: ![Action],
    heard :: ![String],
    -- | The value of the first @Done@ of the functions that are firing.
    ending :: !(Maybe Dynamic),
    -- | Feedback on its way out, newest first.
    fed :: ![Dynamic],
    -- | Calls to start, newest first.
    begun :: ![Calling],
    nextScope :: !ScopeId,
    -- | What the live tasks do when they are stopped.
    cleanups :: !(IntMap Function)
  }

-- | A function with the state of its inputs. Each has a name, what it listens to, how its inputs are told, and what it does.
-- Those that follow events have a birth: user events with a smaller serial were emitted before and are not for it.
-- Firings may wait for the first odometry message, oldest first.
data Live
  = -- | Nothing to keep: reads states and samples.
    forall n. Steady !FunctionName !Interest (Telling n) !(Reading n) !(n -> Effects)
  | -- | Takes every value as it comes.
    forall n. Passing !FunctionName !Interest !Int (Telling n) !(Occurrence -> Arrivals n) ![Reading n] !(n -> Effects)
  | -- | Keeps values until their partners come.
    forall n s. Keeping !FunctionName !Interest !Int (Telling n) !(Trigger s n) !s ![Reading n] !(n -> Effects)

-- | How inputs are told in an error message.
type Telling n = n -> [String] -> [String]

liveName :: Live -> FunctionName
liveName live = case live of
  Steady name _ _ _ _ -> name
  Passing name _ _ _ _ _ _ -> name
  Keeping name _ _ _ _ _ _ _ -> name

-- | Whether an occurrence of this kind may concern the function.
listens :: Interest -> Occurrence -> Live -> Bool
listens kind occurrence live = case live of
  Steady _ kinds _ _ _ -> interestedIn kinds kind
  Passing _ kinds born _ _ _ _ -> interestedIn kinds kind && notBefore born
  Keeping _ kinds born _ _ _ _ _ -> interestedIn kinds kind && notBefore born
  where
    notBefore born = case occurrence of
      Emitted e -> eventSerial e >= born
      _ -> True

-- | What runs until it gives an @r@.
data Running r
  = Returned r
  | -- | A task whose @init@ waits for its inputs.
    forall end. Starting !ScopeId !Live !Function !(Spec end) (end -> Program r)
  | -- | A command given once, that waits for its inputs.
    Giving !ScopeId !Live (Program r)
  | -- | A task at work: its functions, and the tasks they called.
    forall end. Working !ScopeId ![Live] ![Called] !(Spec end) (end -> Program r)
  | -- | The moment to go on.
    Waiting !Double (Program r)
  | -- | Goes on in the next instant.
    Paused (Program r)
  | forall a b. Beside !(Running a) !(Running b) ((a, b) -> Program r)
  | forall a b. Against !(Running a) !(Running b) (Either a b -> Program r)

-- | A task that was called: how far it is, what may cancel it, what the caller does with feedback and with the end.
data Called = forall end. Called !(Running end) !(Maybe Live) (Dynamic -> Maybe Function) (end -> Function)

-- ---------------------------------------------------------------------------------------------
-- The monad: state, firings, and ending at once

newtype Step a = Step {runStep :: World -> (a -> World -> Turn) -> Turn}

instance Functor Step where
  fmap f (Step m) = Step (\w k -> m w (k . f))
  {-# INLINE fmap #-}

instance Applicative Step where
  pure x = Step (\w k -> k x w)
  {-# INLINE pure #-}
  Step f <*> Step m = Step (\w k -> f w (\g w' -> m w' (k . g)))
  {-# INLINE (<*>) #-}

instance Monad Step where
  Step m >>= f = Step (\w k -> m w (\x w' -> runStep (f x) w' k))
  {-# INLINE (>>=) #-}

world :: (World -> a) -> Step a
world f = Step (\w k -> k (f w) w)
{-# INLINE world #-}

change :: (World -> World) -> Step ()
change f = Step (\w k -> let !w' = f w in k () w')
{-# INLINE change #-}

-- | Read and reset the ending of the functions that fired.
takeEnding :: Step (Maybe Dynamic)
takeEnding = Step $ \w k -> case ending w of
  Nothing -> k Nothing w
  found -> k found w {ending = Nothing}
{-# INLINE takeEnding #-}

-- ---------------------------------------------------------------------------------------------
-- Firing

-- | Fire with inputs that are there: one transaction (rule 6).
fire :: ScopeId -> FunctionName -> Telling n -> (n -> Effects) -> Reading n -> Step ()
fire scope name tell give (Reading _ used' look) = Step $ \w k ->
  let before = env w
      here = if envScope before == scope then before else before {envScope = scope}
      inputs = look here
      effects = give inputs
      w' = if used' == 0 then w else w {env = withoutGenerators used' before}
   in Fires (Firing name (tell inputs []) effects (abandon Failed w)) (carryOut scope effects w' (k ()))

-- | Do what a firing says, in order.
carryOut :: ScopeId -> Effects -> World -> (World -> Turn) -> Turn
carryOut _ Nothing' !w k = k w
carryOut scope (Then effect rest) !w k = carryOut scope rest (w `after` effect) k
  where
    after v (Act action) = v {actions = action : actions v}
    after v (Emit value text) =
      v {queue = Event (emitted v) value text : queue v, emitted = emitted v + 1, heard = text : heard v}
    after v (Remember key value) =
      v {env = (env v) {envMemories = IntMap.insertWith (\_ old -> Map.insert key value old) scope (Map.singleton key value) (envMemories (env v))}}
    after v (Share key value) = v {env = (env v) {envParams = Map.insert key value (envParams (env v))}}
    after v (End value) = case ending v of
      Nothing -> v {ending = Just value}
      Just _ -> v
    after v (Feed value) = v {fed = value : fed v}
    after v (StartCall calling) = v {begun = calling : begun v}

-- | Give all live tasks their clean-up, youngest first, each once, and end.
abandon :: Outcome -> World -> Turn
abandon outcome w = case IntMap.maxViewWithKey (cleanups w) of
  Nothing -> Ended outcome (reportOf w)
  Just ((scope, Function name inputs give), rest) ->
    let w' = w {cleanups = rest}
     in runStep (atOnce scope name inputs give) w' (\_ w'' -> abandon outcome w'')

-- | Fire if all inputs can be read now; functions that would have to wait are passed over.
atOnce :: ScopeId -> FunctionName -> Sense n -> (n -> Effects) -> Step ()
atOnce scope name (Sense tell shape) give = case shape of
  Triggered _ -> pure ()
  Level reading -> do
    there <- world (arrived . env)
    if needsOdometry reading && not there then pure () else fire scope name tell give reading

arrived :: Env -> Bool
arrived e = case envOdometry e of
  Nothing -> False
  Just _ -> True

-- | A function with fresh inputs.
liven :: Int -> Function -> Live
liven born (Function name (Sense tell shape) give) = case shape of
  Level reading -> Steady name (if needsOdometry reading then odometryInterest else interestIn Tick) tell reading give
  Triggered t -> case passing t of
    Just arrivals -> Passing name (kinds t) born tell arrivals [] give
    Nothing -> Keeping name (kinds t) born tell t (unused t) [] give
  where
    kinds t = if mayWait t then interest t .|. odometryInterest else interest t

-- | Let a function that listens see what happened, and fire as often as it has unused values. Stops at a 'Done'.
offerTo :: ScopeId -> Occurrence -> Live -> Step Live
offerTo scope occurrence live = case live of
  Steady name _ tell reading give -> live <$ fire scope name tell give reading
  Passing name kinds born tell arrivals waiting0 give -> do
    there <- world (arrived . env)
    let fires = fire scope name tell give
        same waiting = Passing name kinds born tell arrivals waiting give
        late [] = go (arrivals occurrence)
        late (r : rs) = fires r >> unlessOver (same []) (late rs)
        go NoMore = pure (if null waiting0 then live else same [])
        go (Arrival reading more) = fires reading >> unlessOver (same []) (go more)
        -- Some of several arrivals may have to wait while others do not.
        sift waiting NoMore = pure (same waiting)
        sift waiting (Arrival reading more)
          | needsOdometry reading = sift (waiting ++ [reading]) more
          | otherwise = fires reading >> unlessOver (same waiting) (sift waiting more)
    if there then late waiting0 else sift waiting0 (arrivals occurrence)
  Keeping name kinds born tell trigger state0 waiting0 give -> do
    there <- world (arrived . env)
    let fires = fire scope name tell give
        same s waiting = Keeping name kinds born tell trigger s waiting give
        late [] = turn [] 0 state0
        late (r : rs) = fires r >> unlessOver (same state0 []) (late rs)
        turn waiting i s
          | i == turns trigger = pure (same s waiting)
          | otherwise =
            let !s' = offer trigger i occurrence s
             in case ready trigger s' of
                  Nothing -> turn waiting (i + 1) s'
                  Just reading ->
                    let !s'' = used trigger s'
                     in if needsOdometry reading && not there
                          then turn (waiting ++ [reading]) (i + 1) s''
                          else fires reading >> unlessOver (same s'' waiting) (turn waiting (i + 1) s'')
    if there then late waiting0 else turn waiting0 0 state0

-- | 'offerTo', for a function that may not listen.
offerIf :: ScopeId -> Occurrence -> Live -> Step Live
offerIf scope occurrence live
  | listens (interestIn occurrence) occurrence live = offerTo scope occurrence live
  | otherwise = pure live

-- | Go on, unless a 'Done' was given: then this is what is left.
unlessOver :: a -> Step a -> Step a
unlessOver left (Step go) = Step $ \w k -> case ending w of
  Nothing -> go w k
  Just _ -> k left w

-- ---------------------------------------------------------------------------------------------
-- Tasks: getting on

-- | Go on until something has to be waited for, or the steps of this instant are used up.
advance :: Int -> Program r -> Step (Running r)
advance !left program = case program of
  Return x -> pure (Returned x)
  _ | left <= 0 -> pure (Paused program)
  RunTask spec k -> startTask left spec k
  Once function rest -> do
    scope <- freshScope
    begunNow <- tryNow scope (marked function)
    if begunNow
      then afterOnce left scope function rest
      else do
        born <- world emitted
        pure (Giving scope (liven born (marked function)) rest)
  WaitFor seconds rest -> do
    now <- world (envTime . env)
    if seconds <= 0 then advance (left - 1) rest else pure (Waiting (now + seconds) rest)
  Both a b k -> do
    x <- advance (left - 1) a
    y <- advance (left - 1) b
    beside (left - 1) x y k
  First a b k -> do
    x <- advance (left - 1) a
    case x of
      Returned v -> advance (left - 1) (k (Left v))
      _ -> do
        y <- advance (left - 1) b
        against (left - 1) x y k

beside :: Int -> Running a -> Running b -> ((a, b) -> Program r) -> Step (Running r)
beside left (Returned x) (Returned y) k = advance left (k (x, y))
beside _ x y k = pure (Beside x y k)

-- | A race whose left side has not ended.
against :: Int -> Running a -> Running b -> (Either a b -> Program r) -> Step (Running r)
against left x y k = case y of
  Returned v -> do
    stopRunning x
    advance left (k (Right v))
  _ -> pure (Against x y k)

-- | A scope of its own: a new, empty memory.
freshScope :: Step ScopeId
freshScope = Step (\w k -> k (nextScope w) w {nextScope = nextScope w + 1})

-- | Says that a function with this mark has fired.
data Fired = Fired

-- | The function, marked so that the ending tells whether it fired.
marked :: Function -> Function
marked (Function name inputs give) = Function name inputs (append . give)
  where
    append Nothing' = Then (End (toDyn Fired)) Nothing'
    append (Then effect rest) = Then effect (append rest)

-- | The value of a 'Done' in an ending that may only be the mark.
ofDone :: Dynamic -> Maybe Dynamic
ofDone value = case fromDynamic value of
  Just Fired -> Nothing
  Nothing -> Just value

-- | Fire if all inputs can be read now; says whether it did.
tryNow :: ScopeId -> Function -> Step Bool
tryNow scope (Function name (Sense tell shape) give) = case shape of
  Triggered _ -> pure False
  Level reading -> do
    there <- world (arrived . env)
    if needsOdometry reading && not there then pure False else True <$ fire scope name tell give reading

startTask :: Int -> Spec end -> (end -> Program r) -> Step (Running r)
startTask left spec k = do
  scope <- freshScope
  born <- world emitted
  case specStart spec of
    Nothing -> install left scope born spec k
    Just function -> do
      begunNow <- tryNow scope (marked function)
      if begunNow
        then afterStart left scope born function spec k
        else pure (Starting scope (liven born (marked function)) function spec k)

-- | The start has fired: install the controller, unless the start has ended the task.
afterStart :: Int -> ScopeId -> Int -> Function -> Spec end -> (end -> Program r) -> Step (Running r)
afterStart left scope born (Function name _ _) spec k = do
  over <- takeEnding
  case over >>= ofDone of
    Just value -> finish left scope name value [] spec k
    Nothing -> install left scope born spec k

install :: Int -> ScopeId -> Int -> Spec end -> (end -> Program r) -> Step (Running r)
install left scope born spec k = do
  case specStopped spec of
    Nothing -> pure ()
    Just function -> change (\w -> w {cleanups = IntMap.insert scope function (cleanups w)})
  called <- startCalls (left - 1) scope
  pure (Working scope (map (liven born) (specFunctions spec)) called spec k)

-- | A command given once is no task: nothing may end there.
afterOnce :: Int -> ScopeId -> Function -> Program r -> Step (Running r)
afterOnce left scope (Function name _ _) rest = do
  over <- takeEnding
  forget scope
  case over >>= ofDone of
    Just value -> wrongEnd name value "nothing: it is not in a task"
    Nothing -> advance (left - 1) rest

-- | The task has ended: its functions are gone, its calls are stopped, the value is handed on (rule 10).
finish :: Int -> ScopeId -> FunctionName -> Dynamic -> [Called] -> Spec end -> (end -> Program r) -> Step (Running r)
finish left scope name value called spec k = case specEnd spec value of
  Nothing -> wrongEnd name value (specType spec)
  Just x -> do
    mapM_ stopCalled called
    change (\w -> w {cleanups = IntMap.delete scope (cleanups w), begun = []})
    forget scope
    advance (left - 1) (k x)

wrongEnd :: FunctionName -> Dynamic -> String -> Step a
wrongEnd name value wanted =
  Step (\w _ -> abandon (EndedWrongly (nameText name) (show (dynTypeRep value)) wanted) w)

forget :: ScopeId -> Step ()
forget scope = change $ \w ->
  if IntMap.member scope (envMemories (env w))
    then w {env = (env w) {envMemories = IntMap.delete scope (envMemories (env w))}}
    else w

-- | Stop all that is live in there, children first, each clean-up once.
stopRunning :: Running r -> Step ()
stopRunning running = case running of
  Returned _ -> pure ()
  Starting scope _ _ _ _ -> forget scope
  Giving scope _ _ -> forget scope
  Working scope _ called _ _ -> do
    mapM_ stopCalled called
    w <- world id
    case IntMap.lookup scope (cleanups w) of
      Nothing -> pure ()
      Just (Function name inputs give) -> do
        change (\v -> v {cleanups = IntMap.delete scope (cleanups v)})
        atOnce scope name inputs give
        -- A task that is being stopped can neither end nor call.
        change (\v -> v {ending = ending w, begun = begun w})
    forget scope
  Waiting _ _ -> pure ()
  Paused _ -> pure ()
  Beside a b _ -> stopRunning a >> stopRunning b
  Against a b _ -> stopRunning a >> stopRunning b

stopCalled :: Called -> Step ()
stopCalled (Called running _ _ _) = stopRunning running

-- | Start the tasks that were called since the last look.
startCalls :: Int -> ScopeId -> Step [Called]
startCalls left scope = do
  calls <-
    Step
      ( \w k -> case begun w of
          [] -> k [] w
          found -> k (reverse found) w {begun = []}
      )
  case calls of
    [] -> pure []
    _ -> concat <$> mapM start calls
  where
    -- What the caller's functions ended with is not for the called, and comes first.
    start (Calling program canceller feedback response) = do
      born <- world emitted
      outer <- takeFed
      ended <- takeEnding
      running <- advance left program
      called <- reports outer scope (Called running (fmap (liven born) canceller) feedback response)
      case ended of
        Nothing -> pure called
        Just _ -> called <$ change (\w -> w {ending = ended})

-- ---------------------------------------------------------------------------------------------
-- Tasks: what happens

-- | Let everything that runs see what happened, in the program's order.
deliver :: Occurrence -> Running r -> Step (Running r)
deliver occurrence running = case running of
  Returned _ -> pure running
  Starting scope live function spec k -> do
    born <- world emitted
    live' <- offerIf scope occurrence live
    over <- world ending
    case over of
      Nothing -> pure (Starting scope live' function spec k)
      Just _ -> afterStart stepLimit scope born function spec k
  Giving scope live rest -> do
    live' <- offerIf scope occurrence live
    over <- world ending
    case over of
      Nothing -> pure (Giving scope live' rest)
      Just _ -> afterOnce stepLimit scope (Function (liveName live) (Sense (const id) (Level (Reading False 0 (const ())))) (const Nothing')) rest
  Working scope live called spec k -> work scope occurrence live called spec k
  Waiting moment rest
    | Emitted _ <- occurrence -> pure running
    | otherwise -> do
      now <- world (envTime . env)
      if now + rounding >= moment then advance stepLimit rest else pure running
  Paused rest
    | Emitted _ <- occurrence -> pure running
    | otherwise -> advance stepLimit rest
  Beside a b k -> do
    x <- deliver occurrence a
    y <- deliver occurrence b
    beside stepLimit x y k
  Against a b k -> do
    x <- deliver occurrence a
    case x of
      Returned v -> do
        stopRunning b
        advance stepLimit (k (Left v))
      _ -> do
        y <- deliver occurrence b
        against stepLimit x y k

-- | Instants come at sums of steps of 20 ms, whose last digits are rounded: a moment is reached when it is this near, seconds.
-- Far below the shortest time between two messages, far above the rounding of a year in seconds.
rounding :: Double
rounding = 1e-7

-- | One task at work: its functions in order, then the tasks they called before, oldest first. The first 'Done' ends it.
work :: ScopeId -> Occurrence -> [Live] -> [Called] -> Spec end -> (end -> Program r) -> Step (Running r)
work scope occurrence live0 called0 spec k = leaves live0 [] []
  where
    !kind = interestIn occurrence
    -- Functions that have had their turn, newest first; calls begun in this turn.
    leaves [] seen fresh = calls called0 [] (reverse seen) fresh
    leaves (l : ls) seen fresh | not (listens kind occurrence l) = leaves ls (l : seen) fresh
    leaves (l : ls) seen fresh = do
      l' <- offerTo scope occurrence l
      quiet <- world uneventful
      if quiet then leaves ls (l' : seen) fresh else leafDone l l' ls seen fresh
    leafDone l l' ls seen fresh = do
      more <- startCalls stepLimit scope
      over <- takeEnding
      case over of
        Nothing -> leaves ls (l' : seen) (if null more then fresh else fresh ++ more)
        Just value -> finish stepLimit scope (liveName l) value (called0 ++ fresh ++ more) spec k
    calls [] kept live fresh = pure (Working scope live (if null kept then fresh else reverse kept ++ fresh) spec k)
    calls (c : cs) kept live fresh = do
      result <- deliverCalled scope occurrence c
      more <- startCalls stepLimit scope
      over <- takeEnding
      case over of
        Nothing -> calls cs (result ++ kept) live (if null more then fresh else fresh ++ more)
        Just value -> finish stepLimit scope (functionName "end of a call") value (reverse kept ++ result ++ cs ++ fresh ++ more) spec k

-- | Nobody ended or called anything: by far the most firings.
uneventful :: World -> Bool
uneventful w = case ending w of
  Nothing -> null (begun w)
  Just _ -> False

takeFed :: Step [Dynamic]
takeFed =
  Step
    ( \w k -> case fed w of
        [] -> k [] w
        found -> k found w {fed = []}
    )

-- | A called task sees what happened: first whether it is to be cancelled, then its own functions, then its reports.
deliverCalled :: ScopeId -> Occurrence -> Called -> Step [Called]
deliverCalled scope occurrence (Called running cancel feedback response) = do
  cancel' <- traverse (offerIf scope occurrence) cancel
  cancelled <- takeEnding
  case cancelled of
    Just _ -> [] <$ stopRunning running
    Nothing -> do
      outer <- takeFed
      running' <- deliver occurrence running
      reports outer scope (Called running' cancel' feedback response)

-- | Carry out what the caller does with feedback and with the end. Feedback that nobody here takes goes further out.
reports :: [Dynamic] -> ScopeId -> Called -> Step [Called]
reports outer scope called@(Called running _ feedback response) = do
  own <- takeFed
  change (\w -> w {fed = outer})
  mapM_ tell (reverse own)
  case running of
    Returned x -> [] <$ carry (response x)
    _ -> pure [called]
  where
    tell value = case feedback value of
      Just function -> carry function
      Nothing -> change (\w -> w {fed = value : fed w})
    carry (Function name inputs give) = atOnce scope name inputs give

-- ---------------------------------------------------------------------------------------------
-- Running one

-- | How a program starts.
data Start = Start
  { -- | Seconds, see 'Rosy.Seconds'.
    startTime :: !Double,
    startGen :: !StdGen
  }

-- | Begin a program: start its tasks as far as they go without an input.
begin :: Start -> Program r -> Turn
begin start program = runStep (advance stepLimit program) world0 resting
  where
    world0 =
      World
        { env = Env Nothing (startTime start) (startGen start) 0 IntMap.empty Map.empty,
          queue = [],
          emitted = 0,
          actions = [],
          heard = [],
          ending = Nothing,
          fed = [],
          begun = [],
          nextScope = 0,
          cleanups = IntMap.empty
        }

-- | What an instant is about.
data What = Hear !Message | TickNow
  deriving (Eq, Show)

-- | One instant, at so many seconds: a message or a tick, and then rounds of the events that were emitted.
instant :: Double -> What -> Network -> Turn
instant time what (Network running w) = runStep (deliver occurrence running >>= rounds roundLimit) w' resting
  where
    occurrence = case what of
      Hear message -> Sensed message
      TickNow -> Tick
    w' = case what of
      Hear (OdometryMessage o) -> w {env = (env w) {envTime = time, envOdometry = Just o}, fed = []}
      Hear message -> w {env = (env w) {envTime = time}, heard = toldMessage message : heard w, fed = []}
      TickNow -> w {env = (env w) {envTime = time}, fed = []}

-- | Deliver what was emitted, round by round, and what that emits.
rounds :: Int -> Running r -> Step (Running r)
rounds left running
  | left == 0 = pure running
  | otherwise = case running of
    Returned _ -> pure running
    _ -> do
      pending <-
        Step
          ( \w k -> case queue w of
              [] -> k [] w
              found -> k (reverse found) w {queue = []}
          )
      case pending of
        [] -> pure running
        _ -> each pending running >>= rounds (left - 1)
  where
    each [] r = pure r
    each (e : es) r = deliver (Emitted e) r >>= each es

resting :: Running r -> World -> Turn
resting running w = case running of
  Returned _ -> Ended Finished (reportOf w)
  _ -> Settled (Network running w)

-- | End the program from outside: the clean-up of all live tasks.
stop :: Network -> Turn
stop (Network _ w) = abandon Stopped w

-- | Take what the steps since the last time have left for the outside.
collect :: Network -> (Report, Network)
collect (Network running w) = (reportOf w, Network running w {actions = [], heard = []})

-- | What the program remembers, the outermost task's memory first, then what its tasks share: type and value, as Haskell
-- writes them. The values are not computed yet.
remembered :: Network -> [(String, String)]
remembered (Network _ w) = concatMap (kept "Memory") (IntMap.elems (envMemories (env w))) ++ kept "Param" (envParams (env w))
  where
    kept of' memories = [(of' ++ ' ' : showsPrec 11 what "", text) | (what, Kept _ text) <- Map.toAscList memories]

reportOf :: World -> Report
reportOf w = Report (reverse (actions w)) (reverse (heard w))

toldMessage :: Message -> String
toldMessage message = case message of
  ButtonMessage b -> shown b
  BumperMessage b -> shown b
  CliffMessage c -> shown c
  WheelMessage x -> shown x
  StatusMessage s -> shown s
  OdometryMessage _ -> ""
