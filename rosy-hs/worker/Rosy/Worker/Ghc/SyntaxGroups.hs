{-# LANGUAGE GADTs #-}
{-# LANGUAGE RankNTypes #-}
{-# LANGUAGE ScopedTypeVariables #-}
{-# LANGUAGE TypeOperators #-}

-- |
-- Module      : Rosy.Worker.Ghc.SyntaxGroups
-- Description : Places of the composite nodes of a parsed program.
--
-- The text and the places of its composite expressions, patterns, equations and alternatives determine the tree. What brackets enclose has no
-- place of its own: lists, tuples, sections. A call with all its arguments is one node, and so is a chain of operators: the parser does
-- not know their fixities. Names, literals and types are no nodes.
module Rosy.Worker.Ghc.SyntaxGroups
  ( syntaxGroups,
  )
where

import Data.Data (Data, gmapQ)
import Data.List (sortOn)
import Data.Maybe (mapMaybe)
import Data.Ord (Down (..))
import Data.Typeable (eqT, (:~:) (..))
import GHC.Hs
import GHC.Types.SrcLoc
import Rosy.Worker.Ghc.Compat.Syntax
import Rosy.Worker.Problem (Span (..))

-- | In source order, outer nodes before inner ones.
syntaxGroups :: (SrcSpan -> Maybe Span) -> SyntaxTree -> [Span]
syntaxGroups place parsed = sortOn (\s -> (start s, Down (end s))) (mapMaybe place (foldr ((.) . declaration) id (hsmodDecls parsed) []))

-- | Nodes in front of those that follow.
type Groups = [SrcSpan] -> [SrcSpan]

declaration :: LHsDecl GhcPs -> Groups
declaration (At at d) = case d of
  ValD _ b -> binding (At at b)
  _ -> anywhere d

-- | The nodes in a part of the tree. Common constructors are matched in 'expression' and 'pattern'', as in "Rosy.Worker.Ghc.SpanTypes".
anywhere :: forall a. Data a => a -> Groups
anywhere = foldr (.) id . gmapQ here
  where
    here :: forall b. Data b => b -> Groups
    here x
      | Just Refl <- eqT :: Maybe (b :~: LHsExpr GhcPs) = expression x
      | Just Refl <- eqT :: Maybe (b :~: LPat GhcPs) = pattern' x
      | Just Refl <- eqT :: Maybe (b :~: LMatch GhcPs (LHsExpr GhcPs)) = match x
      | Just Refl <- eqT :: Maybe (b :~: LHsBind GhcPs) = binding x
      | Just Refl <- eqT :: Maybe (b :~: LHsType GhcPs) = id
      | Just Refl <- eqT :: Maybe (b :~: SrcSpan) = id
      | otherwise = anywhere x

binding :: LHsBind GhcPs -> Groups
binding (At at b) = case b of
  PatBind {pat_lhs = p, pat_rhs = r} -> (at :) . pattern' p . anywhere r
  _ -> anywhere b

match :: LMatch GhcPs (LHsExpr GhcPs) -> Groups
match (At at m) = (at :) . patterns (m_pats m) . anywhere (m_grhss m)
  where
    patterns = foldr ((.) . pattern') id

expression :: LHsExpr GhcPs -> Groups
expression (At at e) = case e of
  HsVar {} -> id
  HsUnboundVar {} -> id
  HsLit {} -> id
  HsOverLit {} -> id
  Paren x -> expression x
  HsApp _ f x -> (at :) . function f . expression x
  TypeApplied f -> (at :) . function f
  OpApp {} -> (at :) . chain e
  NegApp _ (At _ x@OpApp {}) _ -> (at :) . chain x
  NegApp _ x _ -> expression x
  HsDo _ ListComp _ -> inside
  ExplicitTuple {} -> inside
  ListOf _ -> inside
  ArithSeq {} -> inside
  SectionL {} -> inside
  SectionR {} -> inside
  _ -> (at :) . inside
  where
    inside = anywhere e

-- | A function in front of an argument: what it is given already belongs to the same call.
function :: LHsExpr GhcPs -> Groups
function whole@(At _ e) = case e of
  HsApp _ f x -> function f . expression x
  TypeApplied f -> function f
  Paren (At _ (HsApp _ f x)) -> function f . expression x
  Paren (At _ (TypeApplied f)) -> function f
  Paren x@(At _ (Paren _)) -> function x
  _ -> expression whole

-- | The operands of a chain of operators and signs without brackets.
chain :: HsExpr GhcPs -> Groups
chain e = case e of
  OpApp _ a o b -> operand a . expression o . operand b
  _ -> anywhere e
  where
    operand whole@(At _ x) = case x of
      OpApp {} -> chain x
      NegApp _ y _ -> operand y
      _ -> expression whole

pattern' :: LPat GhcPs -> Groups
pattern' (At at p) = case p of
  VarPat {} -> id
  WildPat {} -> id
  LitPat {} -> id
  NPat {} -> id
  ParenPattern x -> pattern' x
  BangPat _ x -> pattern' x
  LazyPat _ x -> pattern' x
  ListPat {} -> anywhere p
  TuplePat {} -> anywhere p
  ConPat {pat_args = args} -> case args of
    PrefixArguments [] -> id
    PrefixArguments xs -> (at :) . foldr ((.) . pattern') id xs
    InfixCon x y -> (at :) . operand x . operand y
    RecCon fs -> (at :) . foldr ((.) . pattern') id (recordArguments fs)
  _ -> (at :) . anywhere p
  where
    operand whole@(At _ x) = case x of
      ConPat {pat_args = InfixCon l r} -> operand l . operand r
      _ -> pattern' whole
