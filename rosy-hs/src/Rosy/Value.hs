{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DefaultSignatures #-}
{-# LANGUAGE DerivingVia #-}
{-# LANGUAGE ExistentialQuantification #-}
{-# LANGUAGE FlexibleContexts #-}
{-# LANGUAGE FlexibleInstances #-}
{-# LANGUAGE ScopedTypeVariables #-}
{-# LANGUAGE StandaloneDeriving #-}
{-# LANGUAGE TypeApplications #-}
{-# LANGUAGE TypeOperators #-}
{-# LANGUAGE UndecidableInstances #-}

-- |
-- Module      : Rosy.Value
-- Description : Class of values that can be shown, evaluated and given a default, for every declared type.
--
-- Traces and error messages show values of types that the learner declared without a single instance.
-- The worker gives each declared type an instance of 'Value' that only says what its constructors are ('Parts'). Rosy's own types have empty
-- instances, whose methods come from "GHC.Generics": quicker to run, and slower to compile.
-- A type that has no instance, such as a function, still works: it is shown as @_@.
-- This module does not depend on the robot. "Rosy.Model.Default" states the rule for defaults (rule R7) without generics.
--
-- Local functions have signatures here: without one a function is generalised, and its 'Value' is then the last resort.
module Rosy.Value
  ( -- * What it is
    Value (..),
    Default (..),

    -- * Using one
    shown,
    settled,
    Pending,
    nonePending,

    -- * Structure of a declared type
    Parts (..),
    Field (..),
    displayParts,
    settleParts,
    initialFrom,
    construct,
    withField,

    -- * Internals
    GValue,
  )
where

import Control.Applicative ((<|>))
import Control.Exception (throw)
import Data.Char (isAlpha)
import Data.Foldable (asum)
import Data.Int (Int16, Int32, Int64, Int8)
import qualified Data.IntMap as IntMap
import qualified Data.IntSet as IntSet
import qualified Data.List.NonEmpty as NonEmpty
import qualified Data.Map as Map
import Data.Proxy (Proxy (..))
import Data.Ratio (Ratio)
import qualified Data.Sequence as Seq
import qualified Data.Set as Set
import Data.Typeable (TyCon, TypeRep, Typeable, typeRep, typeRepArgs, typeRepTyCon)
import Data.Word (Word16, Word32, Word64, Word8)
import GHC.Generics
import Numeric.Natural (Natural)
import Rosy.Problem (Fault (NoDefault))
import Rosy.Value.DecimalDigits

-- | A value that Rosy can show, finish and begin with. Every declared type has an (empty) instance.
class Typeable a => Value a where
  -- | The value as Haskell's derived @Show@ writes it; what cannot be shown is @_@.
  display :: Int -> a -> ShowS
  default display :: (Generic a, GValue (Rep a)) => Int -> a -> ShowS
  display d x = x `seq` gDisplay d (from x)

  -- | Finish computing the value, visiting at most so many parts; gives what is left of the budget.
  -- A firing is one transaction: what it writes is computed before the next one begins, so that an error
  -- is blamed on the function that made it, and 'Rosy.Memory' keeps values instead of promises.
  settle :: Int -> a -> Int
  default settle :: (Generic a, GValue (Rep a)) => Int -> a -> Int
  settle budget x = gSettle budget (from x)

  -- | The default of the type: the first constructor with a finite default, with default fields (rule R7). 'Nothing' if there is none,
  -- given the types whose default is being searched.
  initial :: Pending -> Maybe a
  default initial :: (Generic a, GValue (Rep a)) => Pending -> Maybe a
  initial pending = enter (typeRep (Proxy @a)) pending >>= fmap to . gInitial

  -- | The constructor and the fields of a value, of a type whose other methods are 'displayParts', 'settleParts' and 'initialFrom'.
  parts :: a -> Parts
  parts _ = Parts "_" [] []

-- | A value taken apart.
data Parts
  = -- | the name of its constructor, the labels of the fields if it has any, and the fields
    Parts String [String] [Field]
  | -- | the precedence and the name of a constructor between its two fields
    InfixParts Int String Field Field

-- | One field of a value taken apart.
data Field
  = -- | the value in it
    forall a. Value a => Field a

-- | Types that a 'Rosy.Memory' may hold: those with a value to start from.
class Value a => Default a where
  -- | What the memory holds before anything was written to it.
  defaultValue :: a
  defaultValue = case initial nonePending of
    Just value -> value
    Nothing -> throw (NoDefault (show (typeRep (Proxy @a))))

-- | The types whose default is being searched, innermost first, each with its constructor and size.
newtype Pending = Pending [(TypeRep, TyCon, Int)]

-- | The start of a search.
nonePending :: Pending
nonePending = Pending []

-- | Search the default of one more type. 'Nothing' if that search cannot end: the type is pending already, or a smaller application of the
-- same type constructor is (@Nest a@ needs @Nest [a]@, which needs @Nest [[a]]@ …).
enter :: TypeRep -> Pending -> Maybe Pending
enter t (Pending pending)
  | any endless pending = Nothing
  | otherwise = Just (Pending ((t, constructor, size) : pending))
  where
    constructor = typeRepTyCon t
    size = sizeOf t
    endless (t', constructor', size') = t' == t || (constructor' == constructor && size' < size)
    sizeOf :: TypeRep -> Int
    sizeOf r = 1 + sum (map sizeOf (typeRepArgs r))

-- | The most parts of one value that are computed when it is written, so that an endless list
-- may be kept in memory. A choice of ours: it bounds the cost of one write to some 10 µs.
settleBudget :: Int
settleBudget = 1000

-- | Evaluate a value (within the budget) before handing it on.
settled :: Value a => a -> a
settled x = settle settleBudget x `seq` x

-- | The value as a learner would write it.
shown :: Value a => a -> String
shown x = display 0 x ""

-- ---------------------------------------------------------------------------------------------
-- What has no instance

-- | The last resort, for fields that cannot be inspected: functions of functions, actions, abstract types.
instance {-# INCOHERENT #-} Typeable a => Value a where
  display _ _ = showString "_"
  settle budget x = x `seq` budget - 1
  initial _ = Nothing

instance (Typeable a, Value b) => Value (a -> b) where
  display _ _ = showString "_"
  settle budget f = f `seq` budget - 1
  initial = fmap const . initial

-- ---------------------------------------------------------------------------------------------
-- The Prelude's types

atom :: Int -> a -> Int
atom budget x = x `seq` budget - 1

-- | Numbers are shown as they are and start at 0.
newtype Number a = Number a

instance (Show a, Num a, Typeable a) => Value (Number a) where
  display d (Number x) = showsPrec d x
  settle budget (Number x) = atom budget x
  initial _ = Just (Number 0)

deriving via Number Int instance Value Int

instance Default Int

deriving via Number Int8 instance Value Int8

instance Default Int8

deriving via Number Int16 instance Value Int16

instance Default Int16

deriving via Number Int32 instance Value Int32

instance Default Int32

deriving via Number Int64 instance Value Int64

instance Default Int64

deriving via Number Word instance Value Word

instance Default Word

deriving via Number Word8 instance Value Word8

instance Default Word8

deriving via Number Word16 instance Value Word16

instance Default Word16

deriving via Number Word32 instance Value Word32

instance Default Word32

deriving via Number Word64 instance Value Word64

instance Default Word64

deriving via Number Integer instance Value Integer

instance Default Integer

deriving via Number Natural instance Value Natural

instance Default Natural

instance Value Double where
  display = showsDouble
  settle = atom
  initial _ = Just 0

instance Default Double

deriving via Number Float instance Value Float

instance Default Float

instance (Integral a, Show a, Typeable a) => Value (Ratio a) where
  display = showsPrec
  settle = atom
  initial _ = Just 0

instance (Integral a, Show a, Typeable a) => Default (Ratio a)

instance Value Char where
  display = showsPrec
  settle = atom
  initial _ = Just ' '

instance Default Char

instance Value ()

instance Default ()

instance Value Bool

instance Default Bool

instance Value Ordering

instance Default Ordering

-- | Memory of a 'Maybe' starts with 'Nothing'.
instance Value a => Value (Maybe a)

instance Default a => Default (Maybe a)

instance (Value a, Value b) => Value (Either a b)

instance (Default a, Default b) => Default (Either a b)

-- | Text.
instance {-# OVERLAPPING #-} Value [Char] where
  display = showsPrec
  settle = settleList
  initial _ = Just ""

instance Value a => Value [a] where
  display _ = displayList
  settle = settleList
  initial _ = Just []

instance Value a => Default [a]

instance Value a => Value (NonEmpty.NonEmpty a) where
  display d (x NonEmpty.:| xs) = showParen (d > 5) (display 6 x . showString " :| " . display 6 xs)
  settle budget (x NonEmpty.:| xs) = settle (settle budget x) xs
  initial = fmap (NonEmpty.:| []) . initial

instance Default a => Default (NonEmpty.NonEmpty a)

displayList :: Value a => [a] -> ShowS
displayList xs = showChar '[' . separated xs . showChar ']'

separated :: Value a => [a] -> ShowS
separated [] = id
separated [y] = display 0 y
separated (y : ys) = display 0 y . showChar ',' . separated ys

settleList :: Value a => Int -> [a] -> Int
settleList !budget xs
  | budget <= 0 = budget
  | otherwise = case xs of
    [] -> budget - 1
    y : ys -> settleList (settle (budget - 1) y) ys

instance (Value k, Value v) => Value (Map.Map k v) where
  display d m = showParen (d > 10) (showString "fromList " . displayList (Map.toAscList m))
  settle budget m = settleList budget (Map.elems m)
  initial _ = Just Map.empty

instance (Value k, Value v) => Default (Map.Map k v)

instance Value a => Value (Set.Set a) where
  display d s = showParen (d > 10) (showString "fromList " . displayList (Set.toAscList s))
  settle = atom
  initial _ = Just Set.empty

instance Value a => Default (Set.Set a)

instance Value a => Value (Seq.Seq a) where
  display d s = showParen (d > 10) (showString "fromList " . displayList (foldr (:) [] s))
  settle budget s = settleList budget (foldr (:) [] s)
  initial _ = Just Seq.empty

instance Value a => Default (Seq.Seq a)

instance Value a => Value (IntMap.IntMap a) where
  display d m = showParen (d > 10) (showString "fromList " . displayList (IntMap.toAscList m))
  settle budget m = settleList budget (IntMap.elems m)
  initial _ = Just IntMap.empty

instance Value a => Default (IntMap.IntMap a)

instance Value IntSet.IntSet where
  display = showsPrec
  settle = atom
  initial _ = Just IntSet.empty

instance Default IntSet.IntSet

-- ---------------------------------------------------------------------------------------------
-- Tuples (the Generic instances of GHC 9.0 stop at seven)

tupled :: [ShowS] -> ShowS
tupled fs = showChar '(' . foldr1 (\a b -> a . showChar ',' . b) fs . showChar ')'

instance (Value a, Value b) => Value (a, b) where
  display _ (a, b) = tupled [display 0 a, display 0 b]
  settle n (a, b) = settle (settle n a) b
  initial p = (,) <$> initial p <*> initial p

instance (Default a, Default b) => Default (a, b)

instance (Value a, Value b, Value c) => Value (a, b, c) where
  display _ (a, b, c) = tupled [display 0 a, display 0 b, display 0 c]
  settle n (a, b, c) = settle (settle (settle n a) b) c
  initial p = (,,) <$> initial p <*> initial p <*> initial p

instance (Default a, Default b, Default c) => Default (a, b, c)

instance (Value a, Value b, Value c, Value d) => Value (a, b, c, d) where
  display _ (a, b, c, d) = tupled [display 0 a, display 0 b, display 0 c, display 0 d]
  settle n (a, b, c, d) = settle (settle (settle (settle n a) b) c) d
  initial p = (,,,) <$> initial p <*> initial p <*> initial p <*> initial p

instance (Default a, Default b, Default c, Default d) => Default (a, b, c, d)

instance (Value a, Value b, Value c, Value d, Value e) => Value (a, b, c, d, e) where
  display _ (a, b, c, d, e) = tupled [display 0 a, display 0 b, display 0 c, display 0 d, display 0 e]
  settle n (a, b, c, d, e) = settle (settle (settle (settle (settle n a) b) c) d) e
  initial p = (,,,,) <$> initial p <*> initial p <*> initial p <*> initial p <*> initial p

instance (Default a, Default b, Default c, Default d, Default e) => Default (a, b, c, d, e)

instance (Value a, Value b, Value c, Value d, Value e, Value f) => Value (a, b, c, d, e, f) where
  display _ (a, b, c, d, e, f) = tupled [display 0 a, display 0 b, display 0 c, display 0 d, display 0 e, display 0 f]
  settle n (a, b, c, d, e, f) = settle (settle (settle (settle (settle (settle n a) b) c) d) e) f
  initial p = (,,,,,) <$> initial p <*> initial p <*> initial p <*> initial p <*> initial p <*> initial p

instance (Default a, Default b, Default c, Default d, Default e, Default f) => Default (a, b, c, d, e, f)

instance (Value a, Value b, Value c, Value d, Value e, Value f, Value g) => Value (a, b, c, d, e, f, g) where
  display _ (a, b, c, d, e, f, g) = tupled [display 0 a, display 0 b, display 0 c, display 0 d, display 0 e, display 0 f, display 0 g]
  settle n (a, b, c, d, e, f, g) = settle (settle (settle (settle (settle (settle (settle n a) b) c) d) e) f) g
  initial p = (,,,,,,) <$> initial p <*> initial p <*> initial p <*> initial p <*> initial p <*> initial p <*> initial p

instance (Default a, Default b, Default c, Default d, Default e, Default f, Default g) => Default (a, b, c, d, e, f, g)

instance (Value a, Value b, Value c, Value d, Value e, Value f, Value g, Value h) => Value (a, b, c, d, e, f, g, h) where
  display _ (a, b, c, d, e, f, g, h) = tupled [display 0 a, display 0 b, display 0 c, display 0 d, display 0 e, display 0 f, display 0 g, display 0 h]
  settle n (a, b, c, d, e, f, g, h) = settle (settle (settle (settle (settle (settle (settle (settle n a) b) c) d) e) f) g) h
  initial p = (,,,,,,,) <$> initial p <*> initial p <*> initial p <*> initial p <*> initial p <*> initial p <*> initial p <*> initial p

instance (Default a, Default b, Default c, Default d, Default e, Default f, Default g, Default h) => Default (a, b, c, d, e, f, g, h)

instance (Value a, Value b, Value c, Value d, Value e, Value f, Value g, Value h, Value i) => Value (a, b, c, d, e, f, g, h, i) where
  display _ (a, b, c, d, e, f, g, h, i) = tupled [display 0 a, display 0 b, display 0 c, display 0 d, display 0 e, display 0 f, display 0 g, display 0 h, display 0 i]
  settle n (a, b, c, d, e, f, g, h, i) = settle (settle (settle (settle (settle (settle (settle (settle (settle n a) b) c) d) e) f) g) h) i
  initial p = (,,,,,,,,) <$> initial p <*> initial p <*> initial p <*> initial p <*> initial p <*> initial p <*> initial p <*> initial p <*> initial p

instance (Default a, Default b, Default c, Default d, Default e, Default f, Default g, Default h, Default i) => Default (a, b, c, d, e, f, g, h, i)

-- ---------------------------------------------------------------------------------------------
-- Declared types

-- | 'display' of a type with 'parts'.
displayParts :: Value a => Int -> a -> ShowS
displayParts d x = case parts x of
  Parts name [] fs -> prefixText d (prefixed name) [display 11 y | Field y <- fs]
  Parts name labels fs -> recordText d (prefixed name) (zip labels [display 0 y | Field y <- fs])
  InfixParts precedence name (Field a) (Field b) -> infixText d precedence name (display (precedence + 1) a) (display (precedence + 1) b)

-- | The name of a constructor before its fields.
prefixed :: String -> ShowS
prefixed name = showParen (isOperator name) (showString name)

isOperator :: String -> Bool
isOperator name = take 1 name == ":"

-- | An infix constructor of this precedence.
infixText :: Int -> Int -> String -> ShowS -> ShowS -> ShowS
infixText d precedence name a b = showParen (d > precedence) (a . showChar ' ' . infixed . showChar ' ' . b)
  where
    infixed = if isOperator name then showString name else showChar '`' . showString name . showChar '`'

-- | A constructor without labels.
prefixText :: Int -> ShowS -> [ShowS] -> ShowS
prefixText _ name [] = name
prefixText d name fs = showParen (d > 10) (foldl (\before part -> before . showChar ' ' . part) name fs)

-- | A constructor with labels.
recordText :: Int -> ShowS -> [(String, ShowS)] -> ShowS
recordText d name fs = showParen (d > 10) (name . showString " {" . commas (map field fs) . showChar '}')
  where
    field (label, part) = showParen (isSymbol label) (showString label) . showString " = " . part
    isSymbol label = not (any (\c -> isAlpha c || c == '_') (take 1 label))
    commas [] = id
    commas ps = foldr1 (\a b -> a . showString ", " . b) ps

-- | 'settle' of a type with 'parts'.
settleParts :: Value a => Int -> a -> Int
settleParts budget x
  | budget <= 0 = budget
  | otherwise = case parts x of
    Parts _ _ fs -> finish (budget - 1) fs
    InfixParts _ _ a b -> finish (budget - 1) [a, b]
  where
    finish :: Int -> [Field] -> Int
    finish left fs = case fs of
      Field y : more | left > 0 -> finish (settle left y) more
      _ -> left

-- | 'initial' of a type with these constructors, in the order of the declaration.
initialFrom :: forall a. Value a => [Pending -> Maybe a] -> Pending -> Maybe a
initialFrom constructors pending = enter (typeRep (Proxy @a)) pending >>= \inside -> asum (map ($ inside) constructors)

-- | A constructor whose fields are to follow.
construct :: a -> Pending -> Maybe a
construct constructor _ = Just constructor

-- | Gives a constructor the default of its next field.
withField :: Value a => (Pending -> Maybe (a -> b)) -> Pending -> Maybe b
withField constructor pending = constructor pending <*> initial pending

-- ---------------------------------------------------------------------------------------------
-- Generics

-- | How a declared type is shown, settled and begun, from its structure.
class GValue f where
  gDisplay :: Int -> f p -> ShowS
  gSettle :: Int -> f p -> Int
  gInitial :: Pending -> Maybe (f p)

instance GValue V1 where
  gDisplay _ _ = showString "_"
  gSettle budget x = x `seq` budget
  gInitial _ = Nothing

instance GValue f => GValue (D1 m f) where
  gDisplay d (M1 x) = gDisplay d x
  gSettle budget (M1 x) = gSettle budget x
  gInitial = fmap M1 . gInitial

-- The first constructor in the source is the leftmost of the sum.
instance (GValue f, GValue g) => GValue (f :+: g) where
  gDisplay d (L1 x) = gDisplay d x
  gDisplay d (R1 x) = gDisplay d x
  gSettle budget (L1 x) = gSettle budget x
  gSettle budget (R1 x) = gSettle budget x
  gInitial pending = (L1 <$> gInitial pending) <|> (R1 <$> gInitial pending)

instance (Constructor c, GFields f) => GValue (C1 c f) where
  gDisplay d m@(M1 x)
    | conIsRecord m = recordText d (prefixed (conName m)) (fields 0 x)
    | otherwise = case conFixity m of
      Infix _ precedence | [(_, a), (_, b)] <- fields (precedence + 1) x -> infixText d precedence (conName m) a b
      _ -> prefixText d (prefixed (conName m)) (map snd (fields 11 x))
  gSettle budget (M1 x)
    | budget <= 0 = budget
    | otherwise = settleFields (budget - 1) x
  gInitial = fmap M1 . initialFields

-- | The fields of one constructor, with their labels.
class GFields f where
  fields :: Int -> f p -> [(String, ShowS)]
  settleFields :: Int -> f p -> Int
  initialFields :: Pending -> Maybe (f p)

instance GFields U1 where
  fields _ _ = []
  settleFields budget _ = budget
  initialFields _ = Just U1

instance (GFields f, GFields g) => GFields (f :*: g) where
  fields d (x :*: y) = fields d x ++ fields d y
  settleFields budget (x :*: y) = settleFields (settleFields budget x) y
  initialFields pending = (:*:) <$> initialFields pending <*> initialFields pending

instance (Selector s, Value a) => GFields (S1 s (K1 i a)) where
  fields d m@(M1 (K1 x)) = [(selName m, display d x)]
  settleFields budget (M1 (K1 x))
    | budget <= 0 = budget
    | otherwise = settle budget x
  initialFields = fmap (M1 . K1) . initial

-- Unboxed fields such as @Int#@ can neither be shown nor have a default.
instance GFields (S1 s (URec u)) where
  fields _ _ = [("", showString "_")]
  settleFields budget _ = budget
  initialFields _ = Nothing
