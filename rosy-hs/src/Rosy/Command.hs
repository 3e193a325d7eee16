{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DefaultSignatures #-}
{-# LANGUAGE DeriveGeneric #-}
{-# LANGUAGE FlexibleInstances #-}
{-# LANGUAGE LinearTypes #-}
{-# LANGUAGE MultiParamTypeClasses #-}
{-# LANGUAGE ScopedTypeVariables #-}
{-# LANGUAGE TypeApplications #-}
{-# LANGUAGE TypeFamilies #-}
{-# LANGUAGE TypeOperators #-}
{-# LANGUAGE UndecidableInstances #-}

-- |
-- Module      : Rosy.Command
-- Description : The types a function may give.
--
-- > … -> Velocity                    -- one command
-- > … -> Maybe Velocity              -- perhaps
-- > … -> (Velocity, Led1)            -- both
-- > … -> Either Sound Led1           -- one of them
-- > … -> [Sound]                     -- each in order
-- > … -> ()                          -- nothing
--
-- A function is a command too: it is carried out when its inputs are there.
-- You need this class only to read an error message: a type that is not a 'Command' cannot be given.
module Rosy.Command
  ( -- * What it is
    Command (..),

    -- * Ending and reporting
    Done (..),
    Feedback (..),
    Cancel (..),

    -- * What may end
    Ends,
    NotInATask,

    -- * For the instances of robots
    sent,
  )
where

import Control.Exception (throw)
import Data.Dynamic (Dynamic, toDyn)
import Data.Proxy (Proxy (..))
import Data.Typeable (typeRep)
import GHC.Generics (Generic)
import Rosy.Channel (Channel, Field (..), Packed (..))
import Rosy.Core
import Rosy.Problem (Fault (..))
import Rosy.Sense (both)
import Rosy.Sensor
import Rosy.Value
import Text.Read (Read (..), lexP, parens, prec, step)
import qualified Text.Read as Read (Lexeme (Ident), readListPrecDefault)

-- | A type that a function may give. For a type that the program declares the instance is empty: it is an event of its own. With a method it is
-- sent on a topic of the robot:
--
-- > instance Command Buzz where
-- >   command = publish "/buzzer" "std_msgs/UInt8" (\Buzz -> [("data", whole 3)])
class Command c where
  -- | What a value of this type does.
  command :: Plan c
  default command :: Value c => Plan c
  command = Plain (\x rest -> Then (Emit (carried x) (shown x)) rest)

-- | A value on its way out of a firing: computed here, so that an error is blamed on the function that made it,
-- and what is kept is a value and no promise.
carried :: Value a => a -> Dynamic
carried x = let !value = settled x in toDyn value

-- | Ends the enclosing task with this value.
newtype Done a = Done
  { -- | The value that the task ends with.
    unDone :: a
  }
  deriving (Eq, Ord, Generic)

instance Show a => Show (Done a) where
  showsPrec d (Done x) = showParen (d > 10) (showString "Done " . showsPrec 11 x)

instance Read a => Read (Done a) where
  readPrec = parens (prec 10 (do Read.Ident "Done" <- lexP; Done <$> step readPrec))
  readListPrec = Read.readListPrecDefault

-- | Tells the one who called the task how far it is.
newtype Feedback a = Feedback
  { -- | What the caller is told.
    unFeedback :: a
  }
  deriving (Eq, Ord, Generic)

instance Show a => Show (Feedback a) where
  showsPrec d (Feedback x) = showParen (d > 10) (showString "Feedback " . showsPrec 11 x)

instance Read a => Read (Feedback a) where
  readPrec = parens (prec 10 (do Read.Ident "Feedback" <- lexP; Feedback <$> step readPrec))
  readListPrec = Read.readListPrecDefault

-- | Asks for a called task to be stopped.
data Cancel = Cancel
  deriving (Eq, Ord, Show, Read, Generic)

instance Value a => Value (Done a) where
  display d (Done x) = showParen (d > 10) (showString "Done " . display 11 x)

instance Value a => Value (Feedback a) where
  display d (Feedback x) = showParen (d > 10) (showString "Feedback " . display 11 x)

instance Value Cancel

instance Sensor Cancel

instance Command Cancel

-- ---------------------------------------------------------------------------------------------
-- The robot

-- | A command on a channel. The noun names it in the message about a number that is none.
sent :: Packed c => String -> Channel -> Plan c
sent noun channel = Plain (\c rest -> let !fields = checked (pack c) in Then (Act (Action channel fields)) rest)
  where
    checked fields
      | all fits fields = fields
      | otherwise = let short = map shortened fields in foldr seq short short
    fits field = case field of
      -- The wire has no word for an endless or undefined number, and no wheel can turn at one.
      Number x
        | x - x == 0 -> True -- Of no other number this is so, and it costs less than to ask twice.
        | otherwise -> throw (NotANumber noun)
      Text _ -> False
      Whole _ -> True
      Structure _ -> True
    shortened field = case field of
      Text text -> let line = take longestLine text in foldr seq (Text line) line
      _ -> fits field `seq` field

-- | The most characters of one text; a bubble shows far fewer. A choice of ours, so that an endless text ends.
longestLine :: Int
longestLine = 10000

instance Default a => Command (Memory a) where
  command = Plain (\(Memory x) rest -> Then (Remember (typeRep (Proxy @a)) (Kept (carried x) (shown x))) rest)

instance Default a => Command (Param a) where
  command = Plain (\(Param x) rest -> Then (Share (typeRep (Proxy @a)) (Kept (carried x) (shown x))) rest)

instance Value a => Command (Done a) where
  command = Plain (\(Done x) rest -> Then (End (carried x) (shown x)) rest)

instance Value a => Command (Feedback a) where
  command = Plain (\(Feedback x) rest -> Then (Feed (carried x) (shown x)) rest)

instance Command Call where
  command = Plain (\(Call calling) rest -> Then (StartCall calling) rest)

-- ---------------------------------------------------------------------------------------------
-- Shapes

instance Command () where command = Plain (\() rest -> rest)

instance Command Never where command = Plain (\Never rest -> rest)

instance (Sensor a, Command b) => Command (a -> b) where
  command = case command of
    Plain give -> Needing sensor (\f x rest -> give (f x) rest)
    Needing more give -> Needing (both sensor more) (\f (x, n) rest -> give (f x) n rest)

instance Command a => Command (Maybe a) where
  command = case command of
    Plain give -> Plain (\m rest -> maybe rest (`give` rest) m)
    Needing s give -> Needing s (\m n rest -> maybe rest (\x -> give x n rest) m)

instance Command a => Command [a] where
  command = case command of
    Plain give -> Plain (flip (foldr give))
    Needing s give -> Needing s (\xs n rest -> foldr (`give` n) rest xs)

instance (Command a, Command b) => Command (Either a b) where
  command = pair command command either

instance (Command a, Command b) => Command (a, b) where
  command = pair command command (\giveA giveB (a, b) rest -> giveA a (giveB b rest))

-- | Two plans as one, whose inputs are those of both.
pair :: Plan a -> Plan b -> ((a -> Effects -> Effects) -> (b -> Effects -> Effects) -> c -> Effects -> Effects) -> Plan c
pair (Plain a) (Plain b) join = Plain (join a b)
pair (Plain a) (Needing s b) join = Needing s (\c n rest -> join a (`b` n) c rest)
pair (Needing s a) (Plain b) join = Needing s (\c n rest -> join (`a` n) b c rest)
pair (Needing s a) (Needing t b) join = Needing (both s t) (\c (n, m) rest -> join (`a` n) (`b` m) c rest)

nested :: (c -> (a, b)) -> Plan (a, b) -> Plan c
nested split (Plain give) = Plain (give . split)
nested split (Needing s give) = Needing s (give . split)

instance (Command a, Command b, Command c) => Command (a, b, c) where
  command = nested (\(a, b, c) -> (a, (b, c))) command

instance (Command a, Command b, Command c, Command d) => Command (a, b, c, d) where
  command = nested (\(a, b, c, d) -> (a, (b, c, d))) command

instance (Command a, Command b, Command c, Command d, Command e) => Command (a, b, c, d, e) where
  command = nested (\(a, b, c, d, e) -> (a, (b, c, d, e))) command

instance (Command a, Command b, Command c, Command d, Command e, Command f) => Command (a, b, c, d, e, f) where
  command = nested (\(a, b, c, d, e, f) -> (a, (b, c, d, e, f))) command

instance (Command a, Command b, Command c, Command d, Command e, Command f, Command g) => Command (a, b, c, d, e, f, g) where
  command = nested (\(a, b, c, d, e, f, g) -> (a, (b, c, d, e, f, g))) command

instance (Command a, Command b, Command c, Command d, Command e, Command f, Command g, Command h) => Command (a, b, c, d, e, f, g, h) where
  command = nested (\(a, b, c, d, e, f, g, h) -> (a, (b, c, d, e, f, g, h))) command

instance (Command a, Command b, Command c, Command d, Command e, Command f, Command g, Command h, Command i) => Command (a, b, c, d, e, f, g, h, i) where
  command = nested (\(a, b, c, d, e, f, g, h, i) -> (a, (b, c, d, e, f, g, h, i))) command

-- ---------------------------------------------------------------------------------------------
-- What may end

-- | @Ends end c@: wherever a @c@ gives 'Done', it is with a value of type @end@.
-- This is how a 'Done' of another type than the task's is refused before the program runs.
-- Types that say nothing about ending have the (incoherent, thus last) instance.
class Ends end c

-- | The @end@ of functions that are in no task, where 'Done' would have nothing to end.
data NotInATask

instance {-# INCOHERENT #-} Ends end c

instance end ~ a => Ends end (Done a)

-- Of any multiplicity: that of a lambda is only settled after this instance is chosen.
instance Ends end b => Ends end (a %m -> b)

instance Ends end a => Ends end (Maybe a)

instance Ends end a => Ends end [a]

instance (Ends end a, Ends end b) => Ends end (Either a b)

instance (Ends end a, Ends end b) => Ends end (a, b)

instance (Ends end a, Ends end b, Ends end c) => Ends end (a, b, c)

instance (Ends end a, Ends end b, Ends end c, Ends end d) => Ends end (a, b, c, d)

instance (Ends end a, Ends end b, Ends end c, Ends end d, Ends end e) => Ends end (a, b, c, d, e)

instance (Ends end a, Ends end b, Ends end c, Ends end d, Ends end e, Ends end f) => Ends end (a, b, c, d, e, f)

instance (Ends end a, Ends end b, Ends end c, Ends end d, Ends end e, Ends end f, Ends end g) => Ends end (a, b, c, d, e, f, g)

instance (Ends end a, Ends end b, Ends end c, Ends end d, Ends end e, Ends end f, Ends end g, Ends end h) => Ends end (a, b, c, d, e, f, g, h)

instance (Ends end a, Ends end b, Ends end c, Ends end d, Ends end e, Ends end f, Ends end g, Ends end h, Ends end i) => Ends end (a, b, c, d, e, f, g, h, i)
