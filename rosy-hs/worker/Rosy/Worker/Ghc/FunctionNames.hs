{-# LANGUAGE GADTs #-}

-- |
-- Module      : Rosy.Worker.Ghc.FunctionNames
-- Description : Names of the functions in a controller expression.
--
-- For @simulate (accelerate, play)@ the trace and the page need the names @accelerate@ and @play@. Values have no names at run time, so the
-- names are determined from the syntax tree: a variable is a name, a tuple or list has the names of its parts, and a variable
-- defined as a tuple or list is resolved.
module Rosy.Worker.Ghc.FunctionNames
  ( Names (..),
    Definitions,
    definitionsOf,
    namesOf,
    functionNames,

    -- * Local definitions
    bindingsOf,
    withLocals,
  )
where

import qualified Data.Map.Strict as Map
import GHC.Hs
import GHC.Types.Name.Occurrence (isVarOcc, occNameString)
import GHC.Types.Name.Reader (RdrName, isUnqual, rdrNameOcc)
import GHC.Types.SrcLoc
import Rosy.Worker.Ghc.Compat.Syntax

-- | The shape of a controller with a name for each function in it.
data Names
  = Name String
  | Names [Names]
  deriving (Eq, Show)

functionNames :: Names -> [String]
functionNames (Name n) = [n]
functionNames (Names ns) = concatMap functionNames ns

-- | Each function or variable with the names of its parameters (if plain) and its right side.
type Definitions = Map.Map String ([Maybe String], LHsExpr GhcPs)

-- | The definitions that consist of one equation without guards; others are not resolved.
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
      ParenPattern q -> parameter q
      SigPat _ q _ -> parameter q
      _ -> Nothing

onlyBody :: GRHSs GhcPs (LHsExpr GhcPs) -> Maybe (LHsExpr GhcPs)
onlyBody rhs = case grhssGRHSs rhs of
  [L _ (GRHS _ [] body)] -> Just (withLocals (localBindings rhs) body)
  _ -> Nothing

-- | Keeps @where@ beside the expression that it belongs to, as a @let@.
withLocals :: HsLocalBinds GhcPs -> LHsExpr GhcPs -> LHsExpr GhcPs
withLocals (EmptyLocalBinds _) body = body
withLocals locals body = letIn locals body

plain :: RdrName -> String
plain = occNameString . rdrNameOcc

-- | The names in a controller expression. A literal value is named after the enclosing definition.
namesOf :: Definitions -> String -> LHsExpr GhcPs -> Names
namesOf top = go (16 :: Int) top Map.empty
  where
    -- The depth bounds the resolution of recursive definitions.
    go depth defs env home located@(At at e) = case e of
      Paren x -> go depth defs env home x
      ExprWithTySig _ x _ -> go depth defs env home x
      ExplicitTuple _ parts _ | Just xs <- mapM present (tupleParts parts) -> Names (map (go depth defs env home) xs)
      ListOf xs -> Names (map (go depth defs env home) xs)
      LetIn locals x -> go depth (Map.union (localDefinitions locals) defs) env home x
      HsDo {} -> Name home
      OpApp _ f (L _ (HsVar _ (L _ op))) x | plain op == "$" -> go depth defs env home (application at f x)
      _ | (L _ (HsVar _ (L _ n)), args) <- applied located, isUnqual n, isVarOcc (rdrNameOcc n) -> variable depth defs env (plain n) args
      Lambda _ -> anonymous at
      LambdaCase _ -> anonymous at
      OpApp {} -> anonymous at
      SectionL {} -> anonymous at
      SectionR {} -> anonymous at
      _ -> Name home

    variable depth defs env n args
      | Just known <- Map.lookup n env, null args = known
      | depth > 0,
        Just (params, body) <- Map.lookup n defs,
        -- A partial application is one function.
        length params == length args,
        parts@(Names _) <- go (depth - 1) defs (boundTo params args `Map.union` Map.fromList [(p, Name p) | Just p <- params]) n body =
        parts
      | n == "priority", Map.notMember n defs, [_, first, second] <- args = Names (map (go depth defs env "priority") [first, second])
      | otherwise = Name n
      where
        boundTo params xs = Map.fromList [(p, go (depth - 1) defs env n x) | (Just p, x) <- zip params xs]

present :: HsTupArg GhcPs -> Maybe (LHsExpr GhcPs)
present (Present _ x) = Just x
present _ = Nothing

localDefinitions :: HsLocalBinds GhcPs -> Definitions
localDefinitions = definitionsOf . bindingsOf

-- | The bindings of a @where@ or a @let@.
bindingsOf :: HsLocalBinds GhcPs -> [LHsBind GhcPs]
bindingsOf locals = case locals of
  HsValBinds _ (ValBinds _ binds _) -> bindList binds
  _ -> []

-- | A function, without parentheses, and its arguments.
applied :: LHsExpr GhcPs -> (LHsExpr GhcPs, [LHsExpr GhcPs])
applied = go []
  where
    go args (L _ (HsApp _ f x)) = go (x : args) f
    go args (L _ (Paren x)) = go args x
    go args f = (f, args)

anonymous :: SrcSpan -> Names
anonymous at = Name ("the function" ++ place)
  where
    place = case at of
      RealSrcSpan s _ -> " at line " ++ show (srcSpanStartLine s)
      UnhelpfulSpan _ -> ""
