{-# LANGUAGE FlexibleInstances #-}
{-# LANGUAGE MultiParamTypeClasses #-}
{-# LANGUAGE UndecidableInstances #-}

-- |
-- Module      : Rosy.Controller
-- Description : Turning plain functions into a controller.
--
-- A controller is a value or function of the shapes in "Rosy.Sensor" and "Rosy.Command", a task, a tuple (to 9) or a list of controllers, or two of them with a priority (rule R16):
--
-- > accelerate                       -- a function
-- > (accelerate, play)               -- two, that fire in this order
-- > (accelerate, blinkFiveTimes)     -- a function and a task that runs beside it
-- > [blink 1, blink 2, blink 3]      -- any number of one type
--
-- A controller is flattened into its functions and tasks in the order in which the program lists them. Their names come
-- from the program's text ("Rosy.Program"); where a name is missing it is @function 1@, @function 2@ and so on.
module Rosy.Controller
  ( -- * What it is
    Controller (..),

    -- * Parts and their names
    Part (..),
    Names (..),
    partsOf,
    single,

    -- * Precedence
    Priority,
    priority,
  )
where

import Rosy.Arbitration
import Rosy.Command
import Rosy.Core
import Rosy.Sense (nothing)
import Rosy.Sensor
import Rosy.Time (Seconds (..))

-- | The names of a controller's functions, in the controller's own shape: a tuple or list of controllers has 'Names', a function has a 'Name'.
-- A 'Name' for several functions names all of them; a list of the wrong length names none.
data Names = Name String | Names [Names]
  deriving (Eq, Show, Read)

-- | One part of a flattened controller.
data Part = Reacts Function | Runs Calling

-- | What a robot can be told to do all the time.
class Controller c where
  -- | Its parts in order. Each takes the name for a function without one.
  parts :: Place -> c -> [String -> Part]

-- | Where a controller stands in the whole one: the positions from the inside to the outside; and the names of its functions.
data Place = Place [Int] Names

-- | A controller's functions and tasks, with a number for functions without a name.
partsOf :: Controller c => Names -> c -> ([Function], [Calling])
partsOf names c = ([f | Reacts f <- flat], [t | Runs t <- flat])
  where
    flat = zipWith (\i part -> part ("function " ++ show i)) [1 :: Int ..] (parts (Place [] names) c)

-- | One function that carries out a command, under the given name or the first one of the names.
single :: Command c => Names -> String -> c -> Function
single names fallback c = leaf names c fallback

leaf :: Command c => Names -> c -> String -> Function
leaf names c fallback = case command of
  Plain give -> Function name nothing (\() -> give c Nothing')
  Needing inputs give -> Function name inputs (\n -> give c n Nothing')
  where
    name = functionName (case names of Name text -> text; Names [one] | Name text <- one -> text; _ -> fallback)

-- | Places for so many parts.
share :: Int -> Place -> [Place]
share n (Place place names) = zipWith (\i -> Place (i : place)) [0 ..] $ case names of
  Name _ -> replicate n names
  Names list | length list == n -> list
  _ -> replicate n (Names [])

instance {-# OVERLAPPABLE #-} Command c => Controller c where
  parts (Place _ names) c = [Reacts . leaf names c]

instance (Sensor a, Command b) => Controller (a -> b) where
  parts (Place _ names) f = [Reacts . leaf names f]

-- | A task starts when the controller does and runs beside it; its result is ignored.
instance Controller (Task end) where
  parts _ t =
    [ \name ->
        Runs
          Calling
            { callArbiters = [],
              callProgram = runTask t Return,
              callCancel = Nothing,
              callFeedback = const Nothing,
              callResponse = const (single (Names []) ("end of " ++ name) ())
            }
    ]

instance Controller c => Controller [c] where
  parts names cs = concat (zipWith parts (share (length cs) names) cs)

instance (Controller a, Controller b) => Controller (a, b) where
  parts names (a, b) = case share 2 names of
    [na, nb] -> parts na a ++ parts nb b
    _ -> [] -- share 2 gives 2

instance (Controller a, Controller b, Controller c) => Controller (a, b, c) where
  parts names (a, b, c) = case share 3 names of
    [na, nb, nc] -> parts na a ++ parts nb b ++ parts nc c
    _ -> [] -- share 3 gives 3

instance (Controller a, Controller b, Controller c, Controller d) => Controller (a, b, c, d) where
  parts names (a, b, c, d) = case share 4 names of
    [na, nb, nc, nd] -> parts na a ++ parts nb b ++ parts nc c ++ parts nd d
    _ -> [] -- share 4 gives 4

instance (Controller a, Controller b, Controller c, Controller d, Controller e) => Controller (a, b, c, d, e) where
  parts names (a, b, c, d, e) = case share 5 names of
    [na, nb, nc, nd, ne] -> parts na a ++ parts nb b ++ parts nc c ++ parts nd d ++ parts ne e
    _ -> [] -- share 5 gives 5

instance (Controller a, Controller b, Controller c, Controller d, Controller e, Controller f) => Controller (a, b, c, d, e, f) where
  parts names (a, b, c, d, e, f) = case share 6 names of
    [na, nb, nc, nd, ne, nf] -> parts na a ++ parts nb b ++ parts nc c ++ parts nd d ++ parts ne e ++ parts nf f
    _ -> [] -- share 6 gives 6

instance (Controller a, Controller b, Controller c, Controller d, Controller e, Controller f, Controller g) => Controller (a, b, c, d, e, f, g) where
  parts names (a, b, c, d, e, f, g) = case share 7 names of
    [na, nb, nc, nd, ne, nf, ng] -> parts na a ++ parts nb b ++ parts nc c ++ parts nd d ++ parts ne e ++ parts nf f ++ parts ng g
    _ -> [] -- share 7 gives 7

instance (Controller a, Controller b, Controller c, Controller d, Controller e, Controller f, Controller g, Controller h) => Controller (a, b, c, d, e, f, g, h) where
  parts names (a, b, c, d, e, f, g, h) = case share 8 names of
    [na, nb, nc, nd, ne, nf, ng, nh] -> parts na a ++ parts nb b ++ parts nc c ++ parts nd d ++ parts ne e ++ parts nf f ++ parts ng g ++ parts nh h
    _ -> [] -- share 8 gives 8

instance (Controller a, Controller b, Controller c, Controller d, Controller e, Controller f, Controller g, Controller h, Controller i) => Controller (a, b, c, d, e, f, g, h, i) where
  parts names (a, b, c, d, e, f, g, h, i) = case share 9 names of
    [na, nb, nc, nd, ne, nf, ng, nh, ni] -> parts na a ++ parts nb b ++ parts nc c ++ parts nd d ++ parts ne e ++ parts nf f ++ parts ng g ++ parts nh h ++ parts ni i
    _ -> [] -- share 9 gives 9

-- | Two controllers, of which the first goes before the second. Made with 'priority'.
data Priority first second = Priority Seconds first second

-- | Where both command the same actuator, the first keeps it for so many seconds after its last command (rule R25).
--
-- > main = simulate (priority 1 backOff driveOn)
--
-- While it does, commands of the second for that actuator have no effect; afterwards its latest one holds again. Either may be any
-- controller: a function, a task, a tuple, another 'priority'. Lines that a program says are never held back.
priority :: (Controller first, Controller second) => Seconds -> first -> second -> Priority first second
priority = Priority

instance (Controller first, Controller second) => Controller (Priority first second) where
  parts place@(Place here _) (Priority (Seconds time) first second) = case share 2 place of
    [inFirst, inSecond] -> map (arbitrated (Leads (max 0 time)) .) (parts inFirst first) ++ map (arbitrated Follows .) (parts inSecond second)
    _ -> [] -- share 2 gives 2
    where
      arbitrated side part = case part of
        Reacts function -> Reacts (arbitrate [Arbiter Nothing here side] function)
        Runs calling -> Runs (arbitrateCalling [Arbiter Nothing here side] calling)

instance (Ends end first, Ends end second) => Ends end (Priority first second)
