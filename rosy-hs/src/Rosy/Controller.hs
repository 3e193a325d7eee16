{-# LANGUAGE FlexibleInstances #-}
{-# LANGUAGE UndecidableInstances #-}

-- |
-- Module      : Rosy.Controller
-- Description : Turning plain functions into a controller.
--
-- A controller is a value or function of the shapes in "Rosy.Sensor" and "Rosy.Command", or a tuple (to 9) or a list of controllers:
--
-- > accelerate                       -- a function
-- > (accelerate, play)               -- two, that fire in this order
-- > [blink 1, blink 2, blink 3]      -- any number of one type
--
-- A controller is flattened into its functions in the order in which the program lists them. Their names come
-- from the program's text ("Rosy.Program"); where a name is missing it is @function 1@, @function 2@ and so on.
module Rosy.Controller
  ( -- * What it is
    Controller (..),

    -- * Names of its functions
    Names (..),
    functionsOf,
    single,
  )
where

import Rosy.Command
import Rosy.Core
import Rosy.Sense (nothing)
import Rosy.Sensor

-- | The names of a controller's functions, in the controller's own shape: a tuple or list of controllers has 'Names', a function has a 'Name'.
-- A 'Name' for several functions names all of them; a list of the wrong length names none.
data Names = Name String | Names [Names]
  deriving (Eq, Show, Read)

-- | What a robot can be told to do all the time.
class Controller c where
  -- | Its functions in order, each with its name if it has one.
  functions :: Names -> c -> [String -> Function]

-- | A controller's functions, with a number for those without a name.
functionsOf :: Controller c => Names -> c -> [Function]
functionsOf names c = zipWith (\i f -> f ("function " ++ show i)) [1 :: Int ..] (functions names c)

-- | One function that carries out a command, under the given name or the first one of the names.
single :: Command c => Names -> String -> c -> Function
single names fallback c = leaf names c fallback

leaf :: Command c => Names -> c -> String -> Function
leaf names c fallback = case command of
  Plain give -> Function name nothing (\() -> give c Nothing')
  Needing inputs give -> Function name inputs (\n -> give c n Nothing')
  where
    name = functionName (case names of Name text -> text; Names [one] | Name text <- one -> text; _ -> fallback)

-- | Names for so many parts.
parts :: Int -> Names -> [Names]
parts n names = case names of
  Name _ -> replicate n names
  Names list | length list == n -> list
  _ -> replicate n (Names [])

instance {-# OVERLAPPABLE #-} Command c => Controller c where
  functions names c = [leaf names c]

instance (Sensor a, Command b) => Controller (a -> b) where
  functions names f = [leaf names f]

instance Controller c => Controller [c] where
  functions names cs = concat (zipWith functions (parts (length cs) names) cs)

instance (Controller a, Controller b) => Controller (a, b) where
  functions names (a, b) = case parts 2 names of
    [na, nb] -> functions na a ++ functions nb b
    _ -> [] -- parts 2 gives 2

instance (Controller a, Controller b, Controller c) => Controller (a, b, c) where
  functions names (a, b, c) = case parts 3 names of
    [na, nb, nc] -> functions na a ++ functions nb b ++ functions nc c
    _ -> [] -- parts 3 gives 3

instance (Controller a, Controller b, Controller c, Controller d) => Controller (a, b, c, d) where
  functions names (a, b, c, d) = case parts 4 names of
    [na, nb, nc, nd] -> functions na a ++ functions nb b ++ functions nc c ++ functions nd d
    _ -> [] -- parts 4 gives 4

instance (Controller a, Controller b, Controller c, Controller d, Controller e) => Controller (a, b, c, d, e) where
  functions names (a, b, c, d, e) = case parts 5 names of
    [na, nb, nc, nd, ne] -> functions na a ++ functions nb b ++ functions nc c ++ functions nd d ++ functions ne e
    _ -> [] -- parts 5 gives 5

instance (Controller a, Controller b, Controller c, Controller d, Controller e, Controller f) => Controller (a, b, c, d, e, f) where
  functions names (a, b, c, d, e, f) = case parts 6 names of
    [na, nb, nc, nd, ne, nf] -> functions na a ++ functions nb b ++ functions nc c ++ functions nd d ++ functions ne e ++ functions nf f
    _ -> [] -- parts 6 gives 6

instance (Controller a, Controller b, Controller c, Controller d, Controller e, Controller f, Controller g) => Controller (a, b, c, d, e, f, g) where
  functions names (a, b, c, d, e, f, g) = case parts 7 names of
    [na, nb, nc, nd, ne, nf, ng] -> functions na a ++ functions nb b ++ functions nc c ++ functions nd d ++ functions ne e ++ functions nf f ++ functions ng g
    _ -> [] -- parts 7 gives 7

instance (Controller a, Controller b, Controller c, Controller d, Controller e, Controller f, Controller g, Controller h) => Controller (a, b, c, d, e, f, g, h) where
  functions names (a, b, c, d, e, f, g, h) = case parts 8 names of
    [na, nb, nc, nd, ne, nf, ng, nh] -> functions na a ++ functions nb b ++ functions nc c ++ functions nd d ++ functions ne e ++ functions nf f ++ functions ng g ++ functions nh h
    _ -> [] -- parts 8 gives 8

instance (Controller a, Controller b, Controller c, Controller d, Controller e, Controller f, Controller g, Controller h, Controller i) => Controller (a, b, c, d, e, f, g, h, i) where
  functions names (a, b, c, d, e, f, g, h, i) = case parts 9 names of
    [na, nb, nc, nd, ne, nf, ng, nh, ni] -> functions na a ++ functions nb b ++ functions nc c ++ functions nd d ++ functions ne e ++ functions nf f ++ functions ng g ++ functions nh h ++ functions ni i
    _ -> [] -- parts 9 gives 9
