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

import Data.List (find, foldl', mapAccumL, nub)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import GHC.Builtin.Names (eitherTyConKey)
import GHC.Builtin.Types (anyTyCon, charTyCon, listTyCon, maybeTyCon, unitTyCon)
import GHC.Core.TyCon (TyCon, isTupleTyCon, tyConName)
import GHC.Core.Type
import GHC.Hs
import GHC.Tc.Types (TcGblEnv (..))
import GHC.Types.Name (getOccString, nameModule_maybe)
import GHC.Types.Name.Occurrence (isVarOcc, occNameString)
import GHC.Types.Name.Reader (RdrName, isUnqual, rdrNameOcc)
import GHC.Types.SrcLoc
import GHC.Types.Unique (hasKey)
import Rosy.Worker.Ghc.Compat.Declarations
import Rosy.Worker.Ghc.Compat.Syntax
import Rosy.Worker.Ghc.Compat.Types
import Rosy.Worker.Ghc.DeclaredTypes (instanceHead)
import Rosy.Worker.Ghc.FunctionNames (bindingsOf, functionNames, namesOf, withLocals)
import Rosy.Worker.Graph
import Rosy.Worker.Problem (Span)

-- | What is fixed for a program.
data Context = Context
  { shown :: Type -> Text,
    place :: SrcSpan -> Maybe Span,
    typeAt :: SrcSpan -> Maybe Type,
    -- | Whether a type is declared by the program.
    isDeclared :: TyCon -> Bool,
    -- | Classes of the robot's topics and the declared types that have an instance of their own.
    onTopics :: [(String, String)],
    -- | Those of them that the program writes itself.
    connections :: [Connection]
  }

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

-- | Expressions that may still be visited. Definitions that use one another twice each would otherwise take exponential time.
type Fuel = Int

fullTank :: Fuel
fullTank = 3000

-- | The parts of the controller or task that @main@ simulates, in the order of the text. Takes the types of all spans.
programGraph :: (Type -> Text) -> (SrcSpan -> Maybe Span) -> [Connection] -> SyntaxTree -> TcGblEnv -> [(SrcSpan, Type)] -> [Part]
programGraph shown' place' connections' parsed checked spans = case Map.lookup "main" top of
  Just main | (inner, argument) : _ <- concatMap (simulations 16 global) (bodies main) -> snd (parts context inner fullTank argument)
  _ -> []
  where
    top = definitionsOf [L at b | L at (ValD _ b) <- hsmodDecls parsed]
    global = Scope top [] "main"
    context =
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

-- | The parts of an expression, and the fuel that is left.
parts :: Context -> Scope -> Fuel -> LHsExpr GhcPs -> (Fuel, [Part])
parts context scope fuel located@(At at e)
  | fuel <= 0 = (0, [])
  | otherwise = case e of
    Paren x -> go scope x
    ExprWithTySig _ x _ -> go scope x
    LetIn locals x -> go (withBindings locals scope) x
    ExplicitTuple _ elements _ -> every scope [x | Present _ x <- tupleParts elements]
    ListOf xs -> every scope xs
    HsDo _ _ (L _ statements)
      | isTask ->
        let next (inner, spare) s = let (inner', (spare', ps)) = statement (parts context) spare inner s in ((inner', spare'), ps)
            ((_, left), found) = mapAccumL next (scope, fuel - 1) statements
         in (left, composed Sequence Nothing (concat found))
    HsIf _ _ a b | isTask -> choice scope [a, b]
    HsCase _ _ MG {mg_alts = L _ alternatives} | isTask -> choice scope [withLocals (localBindings (m_grhss m)) x | L _ m <- alternatives, L _ (GRHS _ _ x) <- grhssGRHSs (m_grhss m)]
    OpApp _ a (L _ (HsVar _ (L _ op))) b
      | isTask, plain op `elem` [">>", "*>", "<*"] -> composed Sequence Nothing <$> every scope [a, b]
      | isTask, plain op == ">>=" -> composed Sequence Nothing <$> every scope [a, resultOf b]
      | isTask, plain op `elem` ["<$>", "<$"] -> go scope b
      | isTask, plain op `elem` ["$>", "<&>"] -> go scope a
    -- An empty place, of whose type nothing may be known.
    HsUnboundVar {} -> (fuel - 1, [])
    _ | maybe False isUnknown type' -> (fuel - 1, [])
    _ | Just (n, args) <- call scope located -> library n args
    _ | Just (n, args) <- applied located -> variable n args
    _ -> (fuel - 1, [leaf (anonymousName located)])
  where
    go inner = parts context inner (fuel - 1)
    every inner xs = concat <$> mapAccumL (parts context inner) (fuel - 1) xs
    type' = typeAt context at
    isTask = maybe False (isTaskType context) type'
    spot = place context at
    -- One part of a chart for each alternative; those that agree are one.
    choice inner xs = case nub <$> mapAccumL (\f x -> composed Sequence Nothing <$> parts context inner f x) (fuel - 1) xs of
      (left, [only]) -> (left, only)
      (left, several) -> (left, [ChartPart Text.empty spot Choice Nothing (concat several) | not (all null several)])

    library n args = case (n, args) of
      ("task", [start, controller]) -> task [start] [controller]
      ("taskWith", [options, controller]) -> task (field "starting" options) [controller]
      ("once", [start]) -> task [start] []
      ("parallel", [a, b]) -> chartOf Parallel Nothing <$> branches [a, b]
      ("race", [a, b]) -> chartOf Race Nothing <$> branches [a, b]
      ("forever", [x]) -> composed Repeat Nothing <$> go scope x
      ("replicateM_", [times, x]) -> composed Repeat (literal times) <$> go scope x
      ("mapM_", [f, _]) -> composed Repeat Nothing <$> go scope (resultOf f)
      ("forM_", [_, f]) -> composed Repeat Nothing <$> go scope (resultOf f)
      ("sequence_", [x]) -> composed Sequence Nothing <$> go scope x
      ("when", [_, x]) -> composed Choice Nothing <$> go scope x
      ("void", [x]) -> go scope x
      ("fmap", [_, x]) -> go scope x
      _ -> (fuel - 1, [])
    task starts controllers =
      let (left, begin) = mapAccumL (parts context scope) (fuel - 1) starts
          (left', run) = mapAccumL (parts context scope) left controllers
       in (left', [TaskPart Text.empty spot (concat begin) (concat run)])
    branches = mapAccumL (\f x -> composed Sequence Nothing <$> parts context scope f x) (fuel - 1)
    chartOf kind n found = [ChartPart Text.empty spot kind n (concat found)]
    composed kind n found
      | null found = []
      | kind == Sequence, [_] <- found = found
      | otherwise = [ChartPart Text.empty spot kind n (if kind == Sequence then concatMap unnamedSteps found else found)]

    variable n args
      | Just d <- Map.lookup n (definitions scope),
        n `notElem` open scope,
        length args == length (parameters d),
        isTask || isComposite d =
        let inner = inside n d args scope
            (left, found) = if isTask then choice inner (bodies d) else every inner (bodies d)
         in (left, named (Text.pack n) (place context (definedAt d)) found)
      | isTask = (fuel - 1, [StepPart (Text.pack n) spot])
      | otherwise = (fuel - 1, [leaf n])
    isComposite d = case bodies d of
      [x] -> isCollection (8 :: Int) x
      _ -> False
    -- A tuple or list, or another name of one. The depth ends a recursion.
    isCollection depth (L _ x) = case x of
      Paren y -> isCollection depth y
      LetIn _ y -> isCollection depth y
      ExplicitTuple {} -> True
      ListOf _ -> True
      HsVar _ (L _ n) | depth > 0, Just d <- Map.lookup (plain n) (definitions scope), null (parameters d), [y] <- bodies d -> isCollection (depth - 1) y
      _ -> False

    leaf n =
      let (ins, out) = maybe ([], unitType) arrows type'
          (more, result) = inputsOfOutput context out
       in FunctionPart (Text.pack n) (definitionPlace n) (map (inputShape context) (ins ++ more)) result
    definitionPlace n = case Map.lookup n (definitions scope) of
      Just d | Just s <- place context (definedAt d) -> Just s
      _ -> spot
    anonymousName = fromMaybe (home scope) . listToMaybe . functionNames . namesOf Map.empty (home scope)
    unitType = mkTyConTy unitTyCon
    isUnknown t = tyConAppTyCon_maybe t == Just anyTyCon

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

without :: [String] -> Scope -> Scope
without names scope = scope {definitions = foldr Map.delete (definitions scope) names}

-- * Names

-- | A call of one of the library's functions that compose controllers and tasks, unless the program defines its name.
call :: Scope -> LHsExpr GhcPs -> Maybe (String, [LHsExpr GhcPs])
call scope x = case applied x of
  Just (n, args) | Map.notMember n (definitions scope), Just (canonical, count) <- lookup n known, length args == count -> Just (canonical, args)
  _ -> Nothing
  where
    known =
      [(n, (n, 2)) | n <- ["task", "taskWith", "parallel", "race", "replicateM_", "mapM_", "forM_", "when", "fmap"]]
        ++ [(n, (n, 1)) | n <- ["simulate", "once", "forever", "sequence_", "void"]]
        ++ [("parallel_", ("parallel", 2)), ("race_", ("race", 2)), ("replicateM", ("replicateM_", 2)), ("mapM", ("mapM_", 2)), ("traverse_", ("mapM_", 2))]
        ++ [("forM", ("forM_", 2)), ("for_", ("forM_", 2)), ("sequence", ("sequence_", 1)), ("unless", ("when", 2)), ("pure", ("pure", 1)), ("return", ("pure", 1))]

-- | A variable with its arguments, also behind a dollar sign.
applied :: LHsExpr GhcPs -> Maybe (String, [LHsExpr GhcPs])
applied = go []
  where
    go args (L _ x) = case x of
      HsVar _ (L _ n) | isUnqual n, isVarOcc (rdrNameOcc n) -> Just (plain n, args)
      HsApp _ f a -> go (a : args) f
      OpApp _ f (L _ (HsVar _ (L _ op))) a | plain op == "$" -> go (a : args) f
      Paren y | not (null args) || isVariable y -> go args y
      _ -> Nothing
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

-- * Types

isTaskType :: Context -> Type -> Bool
isTaskType context t = case splitTyConApp_maybe (see t) of
  Just (c, _) -> getOccString (tyConName c) == "Task" && not (isDeclared context c)
  Nothing -> False

-- | Through synonyms.
see :: Type -> Type
see t = maybe t see (expandSynonym t)

-- | The arguments and the result of a function, without type variables and constraints.
arrows :: Type -> ([Type], Type)
arrows t = case functionParts rho of
  Just (_, from, to) -> let (ins, out) = arrows to in (from : ins, out)
  Nothing -> ([], rho)
  where
    rho = dropConstraints (snd (splitForAlls (see t)))
    dropConstraints u = maybe u (dropConstraints . snd . splitForAlls . see) (constraintResult u)

inputShape :: Context -> Type -> Shape
inputShape context t = case splitTyConApp_maybe (see t) of
  Just (c, args)
    | c == unitTyCon -> leafShape context Taken t
    | isTupleTyCon c -> AllOf (map (inputShape context) args)
    | c `hasKey` eitherTyConKey -> EitherOf (map (inputShape context) args)
    | c == maybeTyCon, [x] <- args -> MaybeOf (inputShape context x)
  _ -> leafShape context Taken t

-- | The shape of an output, and the inputs of functions in it.
inputsOfOutput :: Context -> Type -> ([Type], Shape)
inputsOfOutput context t = case splitTyConApp_maybe (see t) of
  Just (c, args)
    | c == unitTyCon -> ([], AllOf [])
    | isTupleTyCon c -> AllOf <$> mapM (inputsOfOutput context) args
    | c `hasKey` eitherTyConKey -> EitherOf <$> mapM (inputsOfOutput context) args
    | c == maybeTyCon, [x] <- args -> MaybeOf <$> inputsOfOutput context x
    | c == listTyCon, [x] <- args, fmap fst (splitTyConApp_maybe x) /= Just charTyCon -> EachOf <$> inputsOfOutput context x
  _ | Just _ <- functionParts (see t) -> let (ins, out) = arrows t; (more, result) = inputsOfOutput context out in (ins ++ more, result)
  _ -> ([], leafShape context Sent t)

leafShape :: Context -> ConnectionUse -> Type -> Shape
leafShape context use t = Leaf (shown context t) (shown context (expandTypeSynonyms t)) (isEvent declared) (declared >>= connection)
  where
    declared = case splitTyConApp_maybe (see t) of
      Just (c, _) | isDeclared context c -> Just (getOccString (tyConName c))
      _ -> Nothing
    isEvent = maybe False (\n -> (if use == Taken then "Sensor" else "Command", n) `notElem` onTopics context)
    connection n = find (\c -> connectionUse c == use && connectedType c == Text.pack n) (connections context)
