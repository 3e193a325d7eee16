{-# LANGUAGE GADTs #-}

-- |
-- Module      : Rosy.Worker.Ghc.Names
-- Description : What the functions of a controller are called, read off the program's tree.
--
-- A learner writes @simulate (accelerate, play)@; the robot's trace and the page's highlights want the words
-- @accelerate@ and @play@. Values have lost their names when they run, so they are found here, before: a variable is a
-- name, a tuple or list is the names of its parts, and a variable that is defined as a tuple or list is looked into.
module Rosy.Worker.Ghc.Names
  ( Names (..),
    Definitions,
    definitionsOf,
    namesOf,
    leaves,
  )
where

import qualified Data.Map.Strict as Map
import GHC.Data.Bag (bagToList)
import GHC.Hs
import GHC.Types.Name.Occurrence (isVarOcc, occNameString)
import GHC.Types.Name.Reader (RdrName, isUnqual, rdrNameOcc)
import GHC.Types.SrcLoc

-- | The shape of a controller with a name for each function in it.
data Names
  = Name String
  | Names [Names]
  deriving (Eq, Show)

leaves :: Names -> [String]
leaves (Name n) = [n]
leaves (Names ns) = concatMap leaves ns

-- | Each function or variable with the names of its parameters (if plain) and its right side.
type Definitions = Map.Map String ([Maybe String], LHsExpr GhcPs)

-- | The single-equation, guardless definitions among some bindings; others cannot be looked into.
definitionsOf :: [LHsBind GhcPs] -> Definitions
definitionsOf binds = Map.fromList [(n, d) | L _ bind <- binds, Just (n, d) <- [definition bind]]

definition :: HsBind GhcPs -> Maybe (String, ([Maybe String], LHsExpr GhcPs))
definition bind = case bind of
  FunBind {fun_id = L _ n, fun_matches = MG {mg_alts = L _ [L _ match]}}
    | Just body <- onlyBody (m_grhss match) -> Just (plain n, (map parameter (m_pats match), body))
  PatBind {pat_lhs = L _ (VarPat _ (L _ n)), pat_rhs = rhs}
    | Just body <- onlyBody rhs -> Just (plain n, ([], body))
  _ -> Nothing
  where
    parameter :: LPat GhcPs -> Maybe String
    parameter (L _ p) = case p of
      VarPat _ (L _ v) -> Just (plain v)
      ParPat _ q -> parameter q
      SigPat _ q _ -> parameter q
      _ -> Nothing

onlyBody :: GRHSs GhcPs (LHsExpr GhcPs) -> Maybe (LHsExpr GhcPs)
onlyBody rhs = case grhssGRHSs rhs of
  [L _ (GRHS _ [] body)] -> Just (withLocals (unLoc (grhssLocalBinds rhs)) body)
  _ -> Nothing

-- | Keeps @where@ beside the expression that it belongs to, as a @let@.
withLocals :: HsLocalBinds GhcPs -> LHsExpr GhcPs -> LHsExpr GhcPs
withLocals (EmptyLocalBinds _) body = body
withLocals locals body = L (getLoc body) (HsLet noExtField (noLoc locals) body)

plain :: RdrName -> String
plain = occNameString . rdrNameOcc

-- | The names in a controller expression. A value that is written out is called like the definition it stands in.
namesOf :: Definitions -> String -> LHsExpr GhcPs -> Names
namesOf top = go (16 :: Int) top Map.empty
  where
    -- Depth keeps a definition that mentions itself from being looked into for ever.
    go depth defs env home located@(L at e) = case e of
      HsPar _ x -> go depth defs env home x
      ExprWithTySig _ x _ -> go depth defs env home x
      ExplicitTuple _ parts _ | Just xs <- mapM present parts -> Names (map (go depth defs env home) xs)
      ExplicitList _ _ xs -> Names (map (go depth defs env home) xs)
      HsLet _ (L _ locals) x -> go depth (Map.union (localDefinitions locals) defs) env home x
      HsDo {} -> Name home
      OpApp _ f (L _ (HsVar _ (L _ op))) x | plain op == "$" -> go depth defs env home (L at (HsApp noExtField f x))
      _ | (L _ (HsVar _ (L _ n)), args) <- application located, isUnqual n, isVarOcc (rdrNameOcc n) -> variable depth defs env (plain n) args
      HsLam {} -> anonymous at
      HsLamCase {} -> anonymous at
      OpApp {} -> anonymous at
      SectionL {} -> anonymous at
      SectionR {} -> anonymous at
      _ -> Name home

    variable depth defs env n args
      | Just known <- Map.lookup n env, null args = known
      | depth > 0,
        Just (params, body) <- Map.lookup n defs,
        -- With arguments to come it is one function, whatever it will give.
        length params == length args,
        parts@(Names _) <- go (depth - 1) defs (boundTo params args `Map.union` Map.fromList [(p, Name p) | Just p <- params]) n body =
        parts
      | otherwise = Name n
      where
        boundTo params xs = Map.fromList [(p, go (depth - 1) defs env n x) | (Just p, x) <- zip params xs]

present :: LHsTupArg GhcPs -> Maybe (LHsExpr GhcPs)
present (L _ (Present _ x)) = Just x
present _ = Nothing

localDefinitions :: HsLocalBinds GhcPs -> Definitions
localDefinitions locals = case locals of
  HsValBinds _ (ValBinds _ binds _) -> definitionsOf (bagToList binds)
  _ -> Map.empty

-- | A function and its arguments, parentheses around the function taken away.
application :: LHsExpr GhcPs -> (LHsExpr GhcPs, [LHsExpr GhcPs])
application = go []
  where
    go args (L _ (HsApp _ f x)) = go (x : args) f
    go args (L _ (HsPar _ x)) = go args x
    go args f = (f, args)

anonymous :: SrcSpan -> Names
anonymous at = Name ("the function" ++ place)
  where
    place = case at of
      RealSrcSpan s _ -> " at line " ++ show (srcSpanStartLine s)
      UnhelpfulSpan _ -> ""
