{-# LANGUAGE GADTs #-}

-- |
-- Module      : Rosy.Worker.Ghc.DefinitionScope
-- Description : The definitions in scope of an expression of the syntax tree.
--
-- Finds the bodies of functions and variables by name, and tells calls of the library's functions from those of the program's own.
module Rosy.Worker.Ghc.DefinitionScope
  ( Scope (..),
    Definition (..),
    definitionsOf,
    withBindings,
    without,
    inside,

    -- * Parts of expressions
    call,
    applied,
    resultOf,
    literal,
    field,
    plain,
  )
where

import Data.List (foldl')
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import GHC.Hs
import GHC.Types.Name.Occurrence (isVarOcc, occNameString)
import GHC.Types.Name.Reader (RdrName, isUnqual, rdrNameOcc)
import GHC.Types.SrcLoc
import Rosy.Worker.Ghc.Compat.Syntax
import Rosy.Worker.Ghc.FunctionNames (bindingsOf, withLocals)

-- | What is in scope of an expression.
data Scope = Scope
  { definitions :: Map.Map String Definition,
    -- | The definitions that are open around it, so that a recursion ends.
    open :: [String],
    -- | The definition that it is part of.
    home :: String
  }

data Definition = Definition
  { parameters :: [Maybe String],
    bodies :: [LHsExpr GhcPs],
    definedAt :: SrcSpan,
    -- | The scope of an argument, which differs from the one of the body that it is given to.
    closure :: Maybe Scope
  }

without :: [String] -> Scope -> Scope
without names scope = scope {definitions = foldr Map.delete (definitions scope) names}

-- | A call of one of the library's functions that compose controllers and tasks, unless the program defines its name.
call :: Scope -> LHsExpr GhcPs -> Maybe (String, [LHsExpr GhcPs])
call scope x = case applied x of
  Just (n, args) | Map.notMember n (definitions scope), Just (canonical, count) <- lookup n known, length args == count -> Just (canonical, args)
  _ -> Nothing
  where
    known =
      [(n, (n, 2)) | n <- ["task", "taskWith", "parallel", "race", "replicateM_", "mapM_", "forM_", "when", "fmap"]]
        ++ [("priority", ("priority", 3))]
        ++ [(n, (n, 1)) | n <- ["simulate", "once", "forever", "sequence_", "void"]]
        ++ [("parallel_", ("parallel", 2)), ("race_", ("race", 2)), ("replicateM", ("replicateM_", 2)), ("mapM", ("mapM_", 2)), ("traverse_", ("mapM_", 2))]
        ++ [("forM", ("forM_", 2)), ("for_", ("forM_", 2)), ("sequence", ("sequence_", 1)), ("unless", ("when", 2)), ("pure", ("pure", 1)), ("return", ("pure", 1))]

-- | A variable with its arguments, also behind a dollar sign.
applied :: LHsExpr GhcPs -> Maybe (String, [LHsExpr GhcPs])
applied = go []
  where
    go args whole@(L _ x) = case x of
      HsVar _ (L _ n) | isUnqual n, isVarOcc (rdrNameOcc n) -> Just (plain n, args)
      HsApp _ f a -> go (a : args) f
      -- The parser groups every operator to the left, and @f $ g $ x@ is @f (g x)@.
      OpApp z (L _ (OpApp y f d g)) e a | isDollar d, isDollar e -> go args (At (spanOf whole) (OpApp y f d (At (combineSrcSpans (spanOf g) (spanOf a)) (OpApp z g e a))))
      OpApp _ f op a | isDollar op -> go (a : args) f
      Paren y | not (null args) || isVariable y -> go args y
      _ -> Nothing
    isDollar (L _ y) = case y of
      HsVar _ (L _ op) -> plain op == "$"
      _ -> False
    isVariable (L _ y) = case y of
      HsVar {} -> True
      _ -> False

-- | The scope of the body of a definition that is given these arguments.
inside :: String -> Definition -> [LHsExpr GhcPs] -> Scope -> Scope
inside n d args scope = outer {definitions = foldl' bind (definitions outer) (zip (parameters d) args), open = n : open scope, home = n}
  where
    outer = fromMaybe scope (closure d)
    bind known (parameter, x) = case parameter of
      Just p -> Map.insert p (Definition [] [x] (spanOf x) (Just scope)) known
      Nothing -> known

withBindings :: HsLocalBinds GhcPs -> Scope -> Scope
withBindings locals scope = scope {definitions = Map.union (definitionsOf (bindingsOf locals)) (definitions scope)}

-- | Every function and variable with the right sides of all its equations.
definitionsOf :: [LHsBind GhcPs] -> Map.Map String Definition
definitionsOf binds = Map.fromList [(n, d) | At at b <- binds, Just (n, d) <- [definition at b]]
  where
    definition :: SrcSpan -> HsBind GhcPs -> Maybe (String, Definition)
    definition at b = case b of
      FunBind {fun_id = L _ n, fun_matches = MG {mg_alts = L _ equations@(L _ first : rest)}} -> Just (plain n, Definition (map (if null rest then parameter else const Nothing) (m_pats first)) (concat [sides (m_grhss m) | L _ m <- equations]) at Nothing)
      PatBind {pat_lhs = L _ (VarPat _ (L _ n)), pat_rhs = right} -> Just (plain n, Definition [] (sides right) at Nothing)
      _ -> Nothing
    sides right = [withLocals (localBindings right) x | L _ (GRHS _ _ x) <- grhssGRHSs right]
    parameter :: LPat GhcPs -> Maybe String
    parameter (L _ p) = case p of
      VarPat _ (L _ v) -> Just (plain v)
      ParenPattern q -> parameter q
      _ -> Nothing

plain :: RdrName -> String
plain = occNameString . rdrNameOcc

-- | The body of a lambda; a function itself, if it has a name.
resultOf :: LHsExpr GhcPs -> LHsExpr GhcPs
resultOf f@(L _ e) = case e of
  Paren x -> resultOf x
  Lambda MG {mg_alts = L _ [L _ m]} | L _ (GRHS _ _ x) : _ <- grhssGRHSs (m_grhss m) -> x
  _ -> f

literal :: LHsExpr GhcPs -> Maybe Integer
literal (L _ e) = case e of
  Paren x -> literal x
  _ -> integerLiteral e

-- | The value of a field in a record construction or update.
field :: String -> LHsExpr GhcPs -> [LHsExpr GhcPs]
field wanted (L _ e) = case e of
  Paren x -> field wanted x
  _ -> [x | Just fs <- [updatedFields e], (f, x) <- fs, plain f == wanted]
