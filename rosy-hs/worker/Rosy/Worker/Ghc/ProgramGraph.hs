{-# LANGUAGE GADTs #-}
{-# LANGUAGE LambdaCase #-}

-- |
-- Module      : Rosy.Worker.Ghc.ProgramGraph
-- Description : The network that @simulate@ runs, read off the syntax tree and the types of a checked program.
--
-- Follows the argument of @simulate@ through tuples, definitions and tasks. Functions get the inputs and outputs of the type that they
-- have where they are used, so a generic function has the types of its use. Nothing runs: of a task that is chosen at run time
-- every choice is a part, and of a repetition one turn.
module Rosy.Worker.Ghc.ProgramGraph
  ( programGraph,
  )
where

import Data.List (mapAccumL, nub)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import GHC.Builtin.Types (anyTyCon, unitTyCon)
import GHC.Core.TyCon (tyConName)
import GHC.Core.Type
import GHC.Hs
import GHC.Tc.Types (TcGblEnv (..))
import GHC.Types.Name (nameModule_maybe)
import GHC.Types.SrcLoc
import Rosy.Worker.Ghc.Compat.Declarations
import Rosy.Worker.Ghc.Compat.Syntax
import Rosy.Worker.Ghc.DeclaredTypes (instanceHead)
import Rosy.Worker.Ghc.DefinitionScope
import Rosy.Worker.Ghc.FunctionNames (functionNames, namesOf, withLocals)
import Rosy.Worker.Ghc.PartShapes
import Rosy.Worker.Graph
import Rosy.Worker.Problem (Span)

-- | Expressions that may still be visited. Definitions that use one another twice each would otherwise take exponential time.
type Fuel = Int

fullTank :: Fuel
fullTank = 3000

-- | The parts of the controller or task that @main@ simulates, in the order of the text. Takes the types of all spans.
programGraph :: (Type -> Text) -> (SrcSpan -> Maybe Span) -> [Connection] -> SyntaxTree -> TcGblEnv -> [(SrcSpan, Type)] -> [Part]
programGraph shown' place' connections' parsed checked spans = case Map.lookup "main" top of
  Just main | (inner, argument) : _ <- concatMap (simulations 16 global) (bodies main) -> snd (parts fixed inner fullTank argument)
  _ -> []
  where
    top = definitionsOf [L at b | L at (ValD _ b) <- hsmodDecls parsed]
    global = Scope top [] "main"
    fixed =
      Context
        { shown = shown',
          place = place',
          typeAt = \case
            RealSrcSpan s _ -> Map.lookup s types
            UnhelpfulSpan _ -> Nothing,
          isDeclared = \c -> nameModule_maybe (tyConName c) == Just (tcg_mod checked),
          onTopics = concatMap (topics . unLoc) (hsmodDecls parsed),
          connections = connections'
        }
    types = Map.fromListWith (\_ first -> first) [(s, t) | (RealSrcSpan s _, t) <- spans]
    topics :: HsDecl GhcPs -> [(String, String)]
    topics d = case d of
      TyClD _ t@DataDecl {} -> [(c, plain (unLoc (tcdLName t))) | c <- map plain (derivedClasses (tcdDataDefn t)), c `elem` ["Sensor", "Command"]]
      _ -> instanceHead d

-- | The arguments of @simulate@ in an expression, each with its scope.
simulations :: Int -> Scope -> LHsExpr GhcPs -> [(Scope, LHsExpr GhcPs)]
simulations depth scope located@(L _ e)
  | depth == 0 = []
  | Just ("simulate", [x]) <- call scope located = [(scope, x)]
  | otherwise = case e of
    Paren x -> again scope x
    LetIn locals x -> again (withBindings locals scope) x
    ExprWithTySig _ x _ -> again scope x
    HsDo _ _ (L _ statements) -> concatMap snd (snd (mapAccumL (statement (\inner fuel x -> (fuel, again inner x)) 0) scope statements))
    HsIf _ _ a b -> again scope a ++ again scope b
    OpApp _ a _ b -> again scope a ++ again scope b
    _ | Just (n, args) <- applied located, Just d <- Map.lookup n (definitions scope) -> concatMap (again (inside n d args scope)) (bodies d)
    _ -> []
  where
    again = simulations (depth - 1)

-- | An expression that is visited.
data Visit = Visit
  { contextHere :: Context,
    scopeHere :: Scope,
    -- | The fuel that is left for what is in it.
    spare :: Fuel,
    typeHere :: Maybe Type,
    isTask :: Bool,
    spot :: Maybe Span
  }

-- | The parts of an expression, and the fuel that is left.
parts :: Context -> Scope -> Fuel -> LHsExpr GhcPs -> (Fuel, [Part])
parts context scope fuel located@(At at e)
  | fuel <= 0 = (0, [])
  | otherwise = case e of
    Paren x -> go scope x
    ExprWithTySig _ x _ -> go scope x
    LetIn locals x -> go (withBindings locals scope) x
    ExplicitTuple _ elements _ -> every here scope [x | Present _ x <- tupleParts elements]
    ListOf xs -> every here scope xs
    _ | isTask here, Just found <- taskParts here e -> found
    -- An empty place, of whose type nothing may be known.
    HsUnboundVar {} -> (spare here, [])
    _ | maybe False isUnknown type' -> (spare here, [])
    _ | Just (n, args) <- call scope located -> library here n args
    _ | Just (n, args) <- applied located -> variable here n args
    _ -> (spare here, [leaf here (anonymousName located)])
  where
    here = Visit {contextHere = context, scopeHere = scope, spare = fuel - 1, typeHere = type', isTask = maybe False (isTaskType context) type', spot = place context at}
    type' = typeAt context at
    go inner = parts context inner (fuel - 1)
    anonymousName = fromMaybe (home scope) . listToMaybe . functionNames . namesOf Map.empty (home scope)
    isUnknown t = tyConAppTyCon_maybe t == Just anyTyCon

-- | The parts of expressions within an expression.
every :: Visit -> Scope -> [LHsExpr GhcPs] -> (Fuel, [Part])
every here inner xs = concat <$> mapAccumL (parts (contextHere here) inner) (spare here) xs

-- | The parts of one expression within an expression.
only :: Visit -> LHsExpr GhcPs -> (Fuel, [Part])
only here = parts (contextHere here) (scopeHere here) (spare here)

-- * Tasks

-- | The parts of a task that is written with @do@, a choice or an operator.
taskParts :: Visit -> HsExpr GhcPs -> Maybe (Fuel, [Part])
taskParts here e = case e of
  HsDo _ _ (L _ statements) ->
    let next (inner, left) s = let (inner', (left', ps)) = statement (parts (contextHere here)) left inner s in ((inner', left'), ps)
        ((_, rest), found) = mapAccumL next (scopeHere here, spare here) statements
     in Just (rest, composed here Sequence Nothing (concat found))
  HsIf _ _ a b -> Just (choice here (scopeHere here) [a, b])
  HsCase _ _ MG {mg_alts = L _ alternatives} -> Just (choice here (scopeHere here) [withLocals (localBindings (m_grhss m)) x | L _ m <- alternatives, L _ (GRHS _ _ x) <- grhssGRHSs (m_grhss m)])
  OpApp _ a (L _ (HsVar _ (L _ op))) b
    | plain op `elem` [">>", "*>", "<*"] -> Just (composed here Sequence Nothing <$> every here (scopeHere here) [a, b])
    | plain op == ">>=" -> Just (composed here Sequence Nothing <$> every here (scopeHere here) [a, resultOf b])
    | plain op `elem` ["<$>", "<$"] -> Just (only here b)
    | plain op `elem` ["$>", "<&>"] -> Just (only here a)
  _ -> Nothing

-- | One part of a chart for each alternative; those that agree are one.
choice :: Visit -> Scope -> [LHsExpr GhcPs] -> (Fuel, [Part])
choice here inner xs = case nub <$> mapAccumL (\f x -> composed here Sequence Nothing <$> parts (contextHere here) inner f x) (spare here) xs of
  (left, [same]) -> (left, same)
  (left, several) -> (left, [ChartPart Text.empty (spot here) Choice Nothing (concat several) | not (all null several)])

-- | One part of several, unless it is a sequence of one.
composed :: Visit -> Chart -> Maybe Integer -> [Part] -> [Part]
composed here kind n found
  | null found = []
  | kind == Sequence, [_] <- found = found
  | otherwise = [ChartPart Text.empty (spot here) kind n (if kind == Sequence then concatMap unnamedSteps found else found)]

-- | The parts of a call of the library's functions.
library :: Visit -> String -> [LHsExpr GhcPs] -> (Fuel, [Part])
library here n args = case (n, args) of
  ("task", [start, controller]) -> task [start] [controller]
  ("taskWith", [options, controller]) -> task (field "starting" options) [controller]
  ("once", [start]) -> task [start] []
  -- Which of both goes first is no part of the network.
  ("priority", [_, a, b]) -> every here (scopeHere here) [a, b]
  ("parallel", [a, b]) -> chartOf Parallel <$> branches [a, b]
  ("race", [a, b]) -> chartOf Race <$> branches [a, b]
  ("forever", [x]) -> composed here Repeat Nothing <$> only here x
  ("replicateM_", [times, x]) -> composed here Repeat (literal times) <$> only here x
  ("mapM_", [f, _]) -> composed here Repeat Nothing <$> only here (resultOf f)
  ("forM_", [_, f]) -> composed here Repeat Nothing <$> only here (resultOf f)
  ("sequence_", [x]) -> composed here Sequence Nothing <$> only here x
  ("when", [_, x]) -> composed here Choice Nothing <$> only here x
  ("void", [x]) -> only here x
  ("fmap", [_, x]) -> only here x
  _ -> (spare here, [])
  where
    visited = parts (contextHere here) (scopeHere here)
    task starts controllers =
      let (left, begin) = mapAccumL visited (spare here) starts
          (left', run) = mapAccumL visited left controllers
       in (left', [TaskPart Text.empty (spot here) (concat begin) (concat run)])
    branches = mapAccumL (\f x -> composed here Sequence Nothing <$> visited f x) (spare here)
    chartOf kind found = [ChartPart Text.empty (spot here) kind Nothing (concat found)]

-- * Definitions

-- | The parts of a definition that is given these arguments.
variable :: Visit -> String -> [LHsExpr GhcPs] -> (Fuel, [Part])
variable here n args
  | Just d <- Map.lookup n (definitions (scopeHere here)),
    n `notElem` open (scopeHere here),
    length args == length (parameters d),
    isTask here || isComposite (scopeHere here) d =
    let inner = inside n d args (scopeHere here)
        (left, found) = if isTask here then choice here inner (bodies d) else every here inner (bodies d)
     in (left, named (Text.pack n) (place (contextHere here) (definedAt d)) found)
  | isTask here = (spare here, [StepPart (Text.pack n) (spot here)])
  | otherwise = (spare here, [leaf here n])

-- | Whether a definition is a tuple, a list or a priority, or another name of one.
isComposite :: Scope -> Definition -> Bool
isComposite inner d = case bodies d of
  [x] -> isCollection (8 :: Int) x
  _ -> False
  where
    -- The depth ends a recursion.
    isCollection depth located@(L _ x) = case x of
      Paren y -> isCollection depth y
      LetIn _ y -> isCollection depth y
      ExplicitTuple {} -> True
      ListOf _ -> True
      _ | Just ("priority", _) <- call inner located -> True
      HsVar _ (L _ n) | depth > 0, Just other <- Map.lookup (plain n) (definitions inner), null (parameters other), [y] <- bodies other -> isCollection (depth - 1) y
      _ -> False

-- | A function, with the inputs and outputs of the type that it has here.
leaf :: Visit -> String -> Part
leaf here n =
  let (ins, out) = maybe ([], mkTyConTy unitTyCon) arrows (typeHere here)
      (more, result) = inputsOfOutput (contextHere here) out
   in FunctionPart (Text.pack n) definitionPlace (map (inputShape (contextHere here)) (ins ++ more)) result
  where
    definitionPlace = case Map.lookup n (definitions (scopeHere here)) of
      Just d | Just s <- place (contextHere here) (definedAt d) -> Just s
      _ -> spot here

-- | A task takes the name of the outermost definition that is nothing else: that is the word where it is used.
named :: Text -> Maybe Span -> [Part] -> [Part]
named n at found = case found of
  [FunctionPart {}] -> found
  [p] -> [p {partName = n, partPlace = at}]
  _ -> found

-- | The steps of a sequence within a sequence, unless it has a name.
unnamedSteps :: Part -> [Part]
unnamedSteps p = case p of
  ChartPart {chart = Sequence, partName = n} | Text.null n -> steps p
  _ -> [p]

-- | What a statement of @do@ adds: bindings to the scope, or parts.
statement :: (Scope -> Fuel -> LHsExpr GhcPs -> (Fuel, [a])) -> Fuel -> Scope -> ExprLStmt GhcPs -> (Scope, (Fuel, [a]))
statement visit fuel scope (L _ s) = case s of
  LastStmt _ x _ _ -> (scope, visit scope fuel x)
  BodyStmt _ x _ _ -> (scope, visit scope fuel x)
  BindStmt _ p x -> (without (patternNames p) scope, visit scope fuel x)
  LetStmt _ locals -> (withBindings (letStatement locals) scope, (fuel, []))
  _ -> (scope, (fuel, []))
  where
    patternNames :: LPat GhcPs -> [String]
    patternNames (L _ p) = case p of
      VarPat _ (L _ v) -> [plain v]
      ParenPattern q -> patternNames q
      TuplePat _ ps _ -> concatMap patternNames ps
      _ -> []
