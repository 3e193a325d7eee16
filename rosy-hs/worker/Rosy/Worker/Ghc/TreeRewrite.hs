{-# LANGUAGE GADTs #-}
{-# LANGUAGE RankNTypes #-}
{-# LANGUAGE ScopedTypeVariables #-}
{-# LANGUAGE TypeOperators #-}

-- |
-- Module      : Rosy.Worker.Ghc.TreeRewrite
-- Description : Rewriting of the parsed syntax tree: adds what a program may leave out.
--
-- A program needs no header, import or deriving clause, and its functions carry their names at run time. All of that is added to the tree
-- and never to the text, so every span the compiler reports is a span of the learner's text.
module Rosy.Worker.Ghc.TreeRewrite
  ( Rewritten (..),
    ImplicitNames (..),
    implicitNamesWith,
    rewriteProgram,
    controllerFunctions,
  )
where

import Data.Data (Data, gmapQ, gmapT)
import Data.List (nub)
import Data.Maybe (fromMaybe, listToMaybe, maybeToList)
import Data.Set (Set)
import qualified Data.Set as Set
import Data.Typeable (cast, eqT, (:~:) (..))
import GHC (mkModuleName, moduleNameString)
import GHC.Data.Bag (mapBag)
import GHC.Driver.Session (DynFlags, xopt)
import GHC.Hs
import GHC.LanguageExtensions.Type (Extension (ImplicitPrelude))
import GHC.Types.Name.Occurrence
import GHC.Types.Name.Reader (RdrName, isUnqual, mkRdrUnqual, rdrNameOcc)
import GHC.Types.SrcLoc
import Rosy.Worker.Ghc.Compat.Declarations
import Rosy.Worker.Ghc.Compat.Syntax
import Rosy.Worker.Ghc.DeclaredTypes
import Rosy.Worker.Ghc.FunctionNames

-- | The program as it is compiled, and the names of the functions given to the robot.
data Rewritten = Rewritten
  { program :: SyntaxTree,
    controllers :: [Names]
  }

-- | The names in scope of every program: exports of @Rosy@ and of the Prelude. Not GHC's @OccSet@, which in 9.10 keeps one of a type and a
-- constructor of the same name.
data ImplicitNames = ImplicitNames
  { fromRosy :: Set OccName,
    -- | Empty without the implicit Prelude.
    fromPrelude :: Set OccName,
    -- | The types among 'fromRosy', without other names for a type.
    robotTypes :: Set OccName
  }

-- | The names in scope with these flags, which may exclude the Prelude.
implicitNamesWith :: DynFlags -> ImplicitNames -> ImplicitNames
implicitNamesWith flags implicitNames = if xopt ImplicitPrelude flags then implicitNames else implicitNames {fromPrelude = Set.empty}

-- | Adds the header, the imports of Rosy and the Prelude without the names that the program defines itself, the instances of the
-- program's own types, and the names of functions. The predicate selects spans that may contain one of 'controllerFunctions'.
rewriteProgram :: InstanceBodies -> (SrcSpan -> Bool) -> ImplicitNames -> SyntaxTree -> Rewritten
rewriteProgram instances mayName implicitNames parsed =
  Rewritten
    { program =
        parsed
          { hsmodName = Just (node (mkModuleName "Main")),
            hsmodExports = Nothing,
            hsmodImports = imports,
            hsmodDecls = map (if instances == WholeBodies then withTypeName . withTopics (ownTopics derivations) else id) decls ++ concatMap (instancesFor instances derivations) derivations
          },
      controllers = concatMap snd named
    }
  where
    own = definedNames (hsmodDecls parsed)
    imports =
      concatMap (\i -> if importsRosy i then hideDefined (fromRosy implicitNames) own i else [i]) (hsmodImports parsed)
        ++ (if any importsRosy (hsmodImports parsed) then [] else hideDefined (fromRosy implicitNames) own (node (implicitImport "Rosy")))
        ++ (if any (imports' "Prelude") (hsmodImports parsed) then [] else preludeFor (fromPrelude implicitNames) own)
        ++ [node (implicitImport "Rosy.Program") {ideclQualified = QualifiedPre, ideclAs = Just (node (mkModuleName generatedQualifier))}]
    derivations = withStrategies (hsmodDecls parsed)
    named = [if mayName (spanOf d) then nameFunctions hidden definitions d else (d, []) | d <- derivations]
    decls = map fst named
    definitions = definitionsOf binds
    hidden = map occNameString (concatMap bound binds ++ patternVariables (filter (mayName . spanOf) (hsmodDecls parsed)))
    binds = allBinds (mayName . spanOf) parsed
    bound (L _ b) = case b of
      FunBind {fun_id = L _ n} -> [rdrNameOcc n]
      _ -> []

-- * Imports

imports' :: String -> LImportDecl GhcPs -> Bool
imports' m (L _ i) = unLoc (ideclName i) == mkModuleName m

importsRosy :: LImportDecl GhcPs -> Bool
importsRosy l@(L _ i) = imports' "Rosy" l && ideclQualified i == NotQualified

-- | The Prelude of a program that does not import it itself: nothing to add when there is nothing to leave out. What is left out can
-- still be had with the module's name before it, and instances can still be made of its classes.
preludeFor :: Set OccName -> [OccName] -> [LImportDecl GhcPs]
preludeFor exported own
  | any (`Set.member` exported) own = hideDefined exported own (node (implicitImport "Prelude")) ++ [node (implicitImport "Prelude") {ideclQualified = QualifiedPre}]
  | otherwise = []

-- | An import that leaves out what the program defines. A data constructor and a type may share a name of
-- which the program defines only one: the other is then imported by itself.
hideDefined :: Set OccName -> [OccName] -> LImportDecl GhcPs -> [LImportDecl GhcPs]
hideDefined exported own l@(L at i)
  | null clashes = [l]
  | otherwise = case importList i of
    Just (False, _, _) -> [l]
    Just (True, s, items) -> hide s items
    Nothing -> hide noSrcSpan []
  where
    clashes = filter (`Set.member` exported) own
    hide s items = L at (withImportList True s (items ++ map item clashes) i) : [L at (one o) | o <- clashes, not (null (siblings o))]
    one o = withImportList False noSrcSpan (siblings o) (implicitImport (moduleNameString (unLoc (ideclName i))))
    siblings o
      | isTcOcc o, sibling <- mkDataOccFS (occNameFS o), sibling `Set.member` exported, sibling `notElem` own = [importPattern (mkRdrUnqual sibling)]
      | isDataOcc o, sibling <- mkTcOccFS (occNameFS o), sibling `Set.member` exported, sibling `notElem` own = [importType (mkRdrUnqual sibling)]
      | otherwise = []
    item o
      | isTcOcc o || isDataOcc o = importType (mkRdrUnqual (mkTcOccFS (occNameFS o)))
      | otherwise = importValue (mkRdrUnqual o)

-- | Every name that the program defines at top level: functions, types, constructors, fields, classes, methods.
definedNames :: [LHsDecl GhcPs] -> [OccName]
definedNames = nub . concatMap (names . unLoc)
  where
    names :: HsDecl GhcPs -> [OccName]
    names d = map rdrNameOcc $ case d of
      ValD _ b -> boundNames b
      TyClD _ t -> tyClass t
      _ -> []
    tyClass :: TyClDecl GhcPs -> [RdrName]
    tyClass t = case t of
      DataDecl {} -> unLoc (tcdLName t) : concat [constructorNames c ++ constructorFields c | L _ c <- dataConstructors (tcdDataDefn t)]
      ClassDecl {} -> unLoc (tcdLName t) : concat [map unLoc ns | L _ (ClassOpSig _ _ ns _) <- tcdSigs t]
      SynDecl {} -> [unLoc (tcdLName t)]
      FamDecl {} -> [unLoc (fdLName (tcdFam t))]

-- * Topics

-- | The topics of each instance of @Sensor@ and @Command@ that the program writes itself: an expression of type @[Topic]@.
ownTopics :: [LHsDecl GhcPs] -> [LHsExpr GhcPs]
ownTopics everything = [e | L _ (InstD _ (ClsInstD _ i)) <- everything, e <- topicsOf (sigBody (cid_poly_ty i))]
  where
    topicsOf :: LHsType GhcPs -> [LHsExpr GhcPs]
    topicsOf (L _ t) = case t of
      HsParTy _ x -> topicsOf x
      HsAppTy _ (L _ (HsTyVar _ _ (L _ c))) x | Just (of', method, made) <- lookup (plainName c) known -> [nlHsApp (variable of') (typedExpression (variable method) (parenType noSrcSpan (node (HsAppTy noExtField (typeVariable noSrcSpan (added (mkTcOcc made))) x))))]
      _ -> []
    known = [("Sensor", ("sensorTopics", "sensor", "Sense")), ("Command", ("commandTopics", "command", "Plan"))]
    variable = nlHsVar . added . mkVarOcc

-- | Tells the link of these topics before @main@ begins.
withTopics :: [LHsExpr GhcPs] -> LHsDecl GhcPs -> LHsDecl GhcPs
withTopics [] d = d
withTopics topics (L at d) = case d of
  ValD x b | map plainName (boundNames b) == ["main"] -> L at (ValD x (applyingSides "withTopics" (nlList topics) b))
  _ -> L at d

-- | Tells the type of the commands of each instance of @Command@ that the program writes itself.
withTypeName :: LHsDecl GhcPs -> LHsDecl GhcPs
withTypeName (L at d) = case d of
  InstD x (ClsInstD y i) | ("Command", t) : _ <- instanceHead d -> L at (InstD x (ClsInstD y i {cid_binds = mapBag (named t) (cid_binds i)}))
  _ -> L at d
  where
    named :: String -> LHsBind GhcPs -> LHsBind GhcPs
    named t (L spot b)
      | map plainName (boundNames b) == ["command"] = L spot (applyingSides "typeNamed" (stringLiteral t) b)
      | otherwise = L spot b

-- | Applies a function of "Rosy.Program" to an argument and each right-hand side of a definition, and to none of its local definitions.
applyingSides :: Data a => String -> LHsExpr GhcPs -> a -> a
applyingSides function argument = gmapT sides
  where
    sides :: Data a => a -> a
    sides x = case rightSide x of
      Just (GRHS e guards body, back) -> back (GRHS e guards (nlHsApp (nlHsApp (nlHsVar (added (mkVarOcc function))) argument) (paren noSrcSpan body)))
      Nothing | isLocal x -> x
      Nothing -> gmapT sides x
    isLocal :: forall a. Data a => a -> Bool
    isLocal _ = case eqT :: Maybe (a :~: HsLocalBinds GhcPs) of
      Just Refl -> True
      Nothing -> False

rightSide :: forall a. Data a => a -> Maybe (GRHS GhcPs (LHsExpr GhcPs), GRHS GhcPs (LHsExpr GhcPs) -> a)
rightSide x = case eqT :: Maybe (a :~: GRHS GhcPs (LHsExpr GhcPs)) of
  Just Refl -> Just (x, id)
  Nothing -> Nothing

-- * Names of functions

-- | The library's functions that take a controller: the function that takes its names first, and how many
-- arguments it needs to see ("Rosy.Program" lists them).
controllerParameters :: [(String, (String, Int, (LHsExpr GhcPs -> Names) -> [LHsExpr GhcPs] -> [Names]))]
controllerParameters =
  [ ("simulate", ("simulateNamed", 1, map)),
    ("task", ("taskNamed", 2, map)),
    ("taskWith", ("taskWithNamed", 2, \name xs -> concat [[field name "starting" o, field name "stopped" o, name c] | [o, c] <- [xs]])),
    ("once", ("onceNamed", 1, map)),
    ("call", ("callNamed", 2, \name xs -> [Names [field name f o | f <- ["cancelOn", "onFeedback", "onEnd"]] | [_, o] <- [xs]]))
  ]
  where
    -- The names in a field of a record construction or update.
    field name wanted (L _ e) = case e of
      Paren x -> field name wanted x
      _ | Just fs <- updatedFields e -> fromMaybe (Names []) (listToMaybe [name x | (f, x) <- fs, plainName f == wanted])
      _ -> Names []

controllerFunctions :: [String]
controllerFunctions = map fst controllerParameters

-- | Replaces the functions of 'controllerParameters' where the program does not define the word itself.
nameFunctions :: [String] -> Definitions -> LHsDecl GhcPs -> (LHsDecl GhcPs, [Names])
nameFunctions hidden definitions d = (walk d, found d)
  where
    -- What is written out in this declaration is called like it.
    owner = case unLoc d of
      ValD _ b | n : _ <- boundNames b -> plainName n
      _ -> "main"
    table = [known | known@(n, _) <- controllerParameters, n `notElem` hidden]

    walk :: Data a => a -> a
    walk x = case asExpression x of
      Just (e, back) -> back (expression Nothing e)
      Nothing -> gmapT walk x

    found :: Data a => a -> [Names]
    found x = case asExpression x of
      Just (e, _) -> uses Nothing e
      Nothing -> concat (gmapQ found x)

    -- The second argument is what follows a dollar sign.
    expression :: Maybe (LHsExpr GhcPs) -> LHsExpr GhcPs -> LHsExpr GhcPs
    expression follows l@(L at e) = case e of
      OpApp x a op b -> L at (OpApp x (expression (afterDollar op b) a) op (expression follows b))
      HsApp {} -> spine follows l
      Paren inner -> paren (toSpan at) (expression follows inner)
      HsVar {} -> spine follows l
      _ -> L at (gmapT walk e)

    uses :: Maybe (LHsExpr GhcPs) -> LHsExpr GhcPs -> [Names]
    uses follows l@(L _ e) = case e of
      OpApp _ a op b -> uses (afterDollar op b) a ++ uses follows b
      Paren inner -> uses follows inner
      HsApp {} -> use follows l ++ concatMap (uses Nothing) (arguments l)
      HsVar {} -> use follows l
      _ -> concat (gmapQ found e)

    use follows l = maybe [] snd (namedFunction follows l)

    spine follows l = rebuild l
      where
        replacement = namedFunction follows l
        rebuild (L at e) = case e of
          HsApp x f a -> L at (HsApp x (rebuild f) (expression Nothing a))
          Paren inner | isHead inner -> paren (toSpan at) (rebuild inner)
          HsVar {} | Just (f, names) <- replacement -> paren (toSpan at) (foldl (\g n -> application (toSpan at) g (namesExpression n)) (variableExpression (toSpan at) (added (mkVarOcc f))) names)
          HsVar {} -> L at e
          _ -> expression Nothing (L at e)
        isHead (L _ e) = case e of
          HsApp {} -> True
          HsVar {} -> True
          Paren inner -> isHead inner
          _ -> False

    namedFunction follows l = case applied l [] of
      (L _ (HsVar _ (L _ n)), args)
        | isUnqual n,
          Just (f, count, names) <- lookup (plainName n) table,
          xs <- take count (args ++ maybeToList follows),
          length xs == count ->
          Just (f, names (namesOf definitions owner) xs)
      _ -> Nothing

    applied (L _ (HsApp _ f x)) args = applied f (x : args)
    applied (L _ (Paren x)) args = applied x args
    applied f args = (f, args)
    arguments l = snd (applied l [])
    afterDollar (L _ (HsVar _ (L _ op))) b | occNameString (rdrNameOcc op) == "$" = Just b
    afterDollar _ _ = Nothing

asExpression :: forall a. Data a => a -> Maybe (LHsExpr GhcPs, LHsExpr GhcPs -> a)
asExpression x = case eqT :: Maybe (a :~: LHsExpr GhcPs) of
  Just Refl -> Just (x, id)
  Nothing -> Nothing

namesExpression :: Names -> LHsExpr GhcPs
namesExpression n = case n of
  Name s -> nlHsApp (constructor "Name") (stringLiteral s)
  Names ns -> nlHsApp (constructor "Names") (nlList (map namesExpression ns))
  where
    constructor c = nlHsVar (added (mkDataOcc c))

-- * Looking through the tree

-- | Every binding of the program, local ones included where that is asked for; top-level ones win when a name is bound twice.
allBinds :: (LHsDecl GhcPs -> Bool) -> SyntaxTree -> [LHsBind GhcPs]
allBinds within m = localOnes ++ topOnes
  where
    topOnes = [L at b | L at (ValD _ b) <- hsmodDecls m]
    localOnes = concat [nested (L at b) | d@(L at (ValD _ b)) <- hsmodDecls m, within d]
    nested :: Data a => a -> [LHsBind GhcPs]
    nested x = concat (gmapQ here x)
    here :: Data a => a -> [LHsBind GhcPs]
    here x = case cast x of
      Just (HsValBinds _ (ValBinds _ binds _) :: HsLocalBinds GhcPs) -> bindList binds ++ concatMap nested (bindList binds)
      _ -> nested x

-- | Every variable that a pattern binds.
patternVariables :: Data a => a -> [OccName]
patternVariables x = case cast x of
  Just (VarPat _ (L _ n) :: Pat GhcPs) -> [rdrNameOcc n]
  _ -> concat (gmapQ patternVariables x)
