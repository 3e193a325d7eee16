{-# LANGUAGE GADTs #-}
{-# LANGUAGE RankNTypes #-}
{-# LANGUAGE ScopedTypeVariables #-}
{-# LANGUAGE TypeOperators #-}

-- |
-- Module      : Rosy.Worker.Ghc.Add
-- Description : What Rosy adds to a program, added to its tree and never to its text.
--
-- A program needs no header, no import and no deriving, and its functions carry their names into the run. All of that
-- is put into the parsed tree, so that every place the compiler mentions is a place in the learner's text.
module Rosy.Worker.Ghc.Add
  ( Added (..),
    Instances (..),
    Brought (..),
    broughtWith,
    addRosy,
    namingWords,
    generatedQualifier,
  )
where

import Data.Data (Data, gmapQ, gmapT)
import Data.List (nub)
import Data.Maybe (maybeToList)
import Data.Typeable (cast, eqT, (:~:) (..))
import GHC (mkModuleName, moduleNameString)
import GHC.Data.Bag (bagToList, emptyBag, listToBag)
import GHC.Data.FastString (mkFastString)
import GHC.Driver.Session (DynFlags, xopt)
import GHC.Hs
import GHC.LanguageExtensions.Type (Extension (ImplicitPrelude))
import GHC.Types.Basic (PromotionFlag (NotPromoted), SourceText (..))
import GHC.Types.Name.Occurrence
import GHC.Types.Name.Reader (RdrName, isUnqual, mkRdrQual, mkRdrUnqual, rdrNameOcc)
import GHC.Types.SrcLoc
import Rosy.Worker.Ghc.Names

-- | A program as it is compiled, and what its functions are called where they are handed to the robot.
data Added = Added
  { program :: HsModule,
    controllers :: [Names]
  }

-- | Names that Rosy adds live under a qualifier that nobody can write.
generatedQualifier :: String
generatedQualifier = "$rosy"

added :: OccName -> RdrName
added = mkRdrQual (mkModuleName generatedQualifier)

-- | How the instances of declared types get their functions: from the type's structure, or not at all. That is enough to check
-- types, and takes the compiler a tenth of the time; nothing that is compiled so ever runs.
data Instances = Whole | Promised
  deriving (Eq)

-- | The names that a program has without asking: what @import Rosy@ brings, and what the Prelude does.
data Brought = Brought
  { fromRosy :: OccSet,
    -- | None for a program that does without the Prelude.
    fromPrelude :: OccSet
  }

-- | What a program with these flags has: it may have left out the Prelude.
broughtWith :: DynFlags -> Brought -> Brought
broughtWith flags brought = if xopt ImplicitPrelude flags then brought else brought {fromPrelude = emptyOccSet}

-- | Adds the header, the imports of Rosy and the Prelude without the names that the program defines itself, the instances of the
-- program's own types, and the names of functions. The predicate says where one of 'namingWords' may stand.
addRosy :: Instances -> (SrcSpan -> Bool) -> Brought -> HsModule -> Added
addRosy instances mayName brought parsed =
  Added
    { program =
        parsed
          { hsmodName = Just (noLoc (mkModuleName "Main")),
            hsmodExports = Nothing,
            hsmodImports = imports,
            hsmodDecls = decls ++ concatMap (instancesFor instances (hsmodDecls parsed)) (hsmodDecls parsed)
          },
      controllers = concatMap snd named
    }
  where
    own = definedNames (hsmodDecls parsed)
    imports =
      concatMap (\i -> if importsRosy i then giveWay (fromRosy brought) own i else [i]) (hsmodImports parsed)
        ++ (if any importsRosy (hsmodImports parsed) then [] else giveWay (fromRosy brought) own (noLoc (implicit "Rosy")))
        ++ (if any (imports' "Prelude") (hsmodImports parsed) then [] else preludeFor (fromPrelude brought) own)
        ++ [noLoc (implicit "Rosy.Program") {ideclQualified = QualifiedPre, ideclAs = Just (noLoc (mkModuleName generatedQualifier))}]
    named = [if mayName (getLoc d) then nameFunctions hidden definitions d else (d, []) | d <- hsmodDecls parsed]
    decls = map fst named
    definitions = definitionsOf binds
    hidden = map occNameString (concatMap bound binds ++ variables (filter (mayName . getLoc) (hsmodDecls parsed)))
    binds = allBinds (mayName . getLoc) parsed
    bound (L _ b) = case b of
      FunBind {fun_id = L _ n} -> [rdrNameOcc n]
      _ -> []

implicit :: String -> ImportDecl GhcPs
implicit m = (simpleImportDecl (mkModuleName m)) {ideclImplicit = True}

-- * Imports

imports' :: String -> LImportDecl GhcPs -> Bool
imports' m (L _ i) = unLoc (ideclName i) == mkModuleName m

importsRosy :: LImportDecl GhcPs -> Bool
importsRosy l@(L _ i) = imports' "Rosy" l && ideclQualified i == NotQualified

-- | The Prelude of a program that does not import it itself: nothing to add when there is nothing to leave out. What is left out can
-- still be had with the module's name before it, and instances can still be made of its classes.
preludeFor :: OccSet -> [OccName] -> [LImportDecl GhcPs]
preludeFor exported own
  | any (`elemOccSet` exported) own = giveWay exported own (noLoc (implicit "Prelude")) ++ [noLoc (implicit "Prelude") {ideclQualified = QualifiedPre}]
  | otherwise = []

-- | An import that leaves out what the program defines. A data constructor and a type may share a name of
-- which the program defines only one: the other is then imported by itself.
giveWay :: OccSet -> [OccName] -> LImportDecl GhcPs -> [LImportDecl GhcPs]
giveWay exported own l@(L at i)
  | null clashes = [l]
  | otherwise = case ideclHiding i of
    Just (False, _) -> [l]
    Just (True, L s items) -> hide s items
    Nothing -> hide noSrcSpan []
  where
    clashes = filter (`elemOccSet` exported) own
    hide s items = L at i {ideclHiding = Just (True, L s (items ++ map item clashes))} : [L at (one o) | o <- clashes, not (null (siblings o))]
    one o = (implicit (moduleNameString (unLoc (ideclName i)))) {ideclHiding = Just (False, noLoc (siblings o))}
    siblings o
      | isTcOcc o, sibling <- mkDataOccFS (occNameFS o), sibling `elemOccSet` exported, sibling `notElem` own = [noLoc (IEVar noExtField (noLoc (IEPattern (noLoc (mkRdrUnqual sibling)))))]
      | isDataOcc o, sibling <- mkTcOccFS (occNameFS o), sibling `elemOccSet` exported, sibling `notElem` own = [noLoc (IEThingAbs noExtField (wrapped sibling))]
      | otherwise = []
    item o
      | isTcOcc o || isDataOcc o = noLoc (IEThingAbs noExtField (wrapped (mkTcOccFS (occNameFS o))))
      | otherwise = noLoc (IEVar noExtField (wrapped o))
    wrapped o = noLoc (IEName (noLoc (mkRdrUnqual o)))

-- | Every name that the program defines at top level: functions, types, constructors, fields, classes, methods.
definedNames :: [LHsDecl GhcPs] -> [OccName]
definedNames = nub . concatMap (names . unLoc)
  where
    names :: HsDecl GhcPs -> [OccName]
    names d = map rdrNameOcc $ case d of
      ValD _ b -> collectHsBindBinders b
      TyClD _ t -> tyClass t
      _ -> []
    tyClass :: TyClDecl GhcPs -> [RdrName]
    tyClass t = case t of
      DataDecl {} -> unLoc (tcdLName t) : concatMap (constructor . unLoc) (dd_cons (tcdDataDefn t))
      ClassDecl {} -> unLoc (tcdLName t) : concat [map unLoc ns | L _ (ClassOpSig _ _ ns _) <- tcdSigs t]
      SynDecl {} -> [unLoc (tcdLName t)]
      FamDecl {} -> [unLoc (fdLName (tcdFam t))]
    constructor, fields :: ConDecl GhcPs -> [RdrName]
    constructor c = constructorNames c ++ fields c
    fields c = case c of
      ConDeclH98 {con_args = RecCon (L _ fs)} -> concatMap field fs
      ConDeclGADT {con_args = RecCon (L _ fs)} -> concatMap field fs
      _ -> []
    -- getConNames is for renamed trees only.
    constructorNames :: ConDecl GhcPs -> [RdrName]
    constructorNames c = case c of
      ConDeclH98 {con_name = L _ n} -> [n]
      ConDeclGADT {con_names = ns} -> map unLoc ns
    field :: LConDeclField GhcPs -> [RdrName]
    field (L _ f) = [unLoc (rdrNameFieldOcc n) | L _ n <- cd_fld_names f]

-- * Instances

-- | The instances that make a declared type an event of its own ("Rosy.Program" says which). They stand at the place of the
-- declaration, so that whatever is wrong with them is wrong with it.
instancesFor :: Instances -> [LHsDecl GhcPs] -> LHsDecl GhcPs -> [LHsDecl GhcPs]
instancesFor instances everything (L at d) = case d of
  TyClD _ t@DataDecl {tcdDataDefn = defn}
    | all (isPlain . unLoc) (dd_cons defn) ->
      [L at (DerivD noExtField (generic t)) | not promised, not (derives "Generic" defn), not (has "Generic" t)]
        ++ concatMap (instance' t) [("Value", ["display", "settle", "initial"]), ("Default", ["defaultValue"]), ("Sensor", ["sense"]), ("Command", ["command"])]
    where
      -- What has a structure of its own kind may have none of the usual one, and must be tried.
      promised = instances == Promised && not (any hasInnerTypes (dd_cons defn))
      instance' = if promised then whole else empty
  _ -> []
  where
    isPlain :: ConDecl GhcPs -> Bool
    isPlain c = case c of
      ConDeclH98 {con_forall = L _ False, con_mb_cxt = Nothing} -> True
      _ -> False
    derives :: String -> HsDataDefn GhcPs -> Bool
    derives wanted defn = wanted `elem` [plainName n | L _ clause <- unLoc (dd_derivs defn), HsIB {hsib_body = L _ (HsTyVar _ _ (L _ n))} <- unLoc (deriv_clause_tys clause)]
    -- The program's own instance is the better one.
    has :: String -> TyClDecl GhcPs -> Bool
    has wanted t = (wanted, plainName (unLoc (tcdLName t))) `elem` concatMap (instanceHead . unLoc) everything
    generic :: TyClDecl GhcPs -> DerivDecl GhcPs
    generic t =
      DerivDecl
        { deriv_ext = noExtField,
          deriv_type = HsWC noExtField (headOf "Generic" t),
          deriv_strategy = Just (noLoc StockStrategy),
          deriv_overlap_mode = Nothing
        }
    empty, whole :: TyClDecl GhcPs -> (String, [String]) -> [LHsDecl GhcPs]
    empty t (c, _) = with emptyBag t c
    whole t (c, methods) = with (listToBag [mkSimpleGeneratedFunBind at (mkRdrUnqual (mkVarOcc m)) [] (nlHsVar (added (mkVarOcc m))) | m <- methods]) t c
    with binds t c =
      [ L at . InstD noExtField . ClsInstD noExtField $
          ClsInstDecl {cid_ext = noExtField, cid_poly_ty = headOf c t, cid_binds = binds, cid_sigs = [], cid_tyfam_insts = [], cid_datafam_insts = [], cid_overlap_mode = Nothing}
        | not (has c t)
      ]
    headOf :: String -> TyClDecl GhcPs -> LHsSigType GhcPs
    headOf c t = HsIB noExtField (inContext t (L at (HsAppTy noExtField (name (added (mkTcOcc c))) (applied t))))
    inContext :: TyClDecl GhcPs -> LHsType GhcPs -> LHsType GhcPs
    inContext t body
      | null (parameters t) = body
      | otherwise = L at (HsQualTy noExtField (L at [L at (HsAppTy noExtField (name (added (mkTcOcc (classFor t v)))) (name v)) | v <- parameters t]) body)
    -- What a parameter must be: something to hold, or something that holds others.
    classFor :: TyClDecl GhcPs -> RdrName -> String
    classFor t v = if plainName v `elem` appliedVariables (tcdDataDefn t) then "Typeable" else "Value"
    parameters :: TyClDecl GhcPs -> [RdrName]
    parameters t = map hsLTyVarName (hsQTvExplicit (tcdTyVars t))
    applied :: TyClDecl GhcPs -> LHsType GhcPs
    applied t = case parameters t of
      [] -> name (unLoc (tcdLName t))
      vs -> L at (HsParTy noExtField (foldl (\f v -> L at (HsAppTy noExtField f (name v))) (name (unLoc (tcdLName t))) vs))
    name :: RdrName -> LHsType GhcPs
    name n = L at (HsTyVar noExtField NotPromoted (L at n))

-- | Whether there are types with variables of their own inside.
hasInnerTypes :: Data a => a -> Bool
hasInnerTypes x = case cast x of
  Just (HsForAllTy {} :: HsType GhcPs) -> True
  Just HsQualTy {} -> True
  _ -> or (gmapQ hasInnerTypes x)

instanceHead :: HsDecl GhcPs -> [(String, String)]
instanceHead d = case d of
  InstD _ (ClsInstD _ i) -> of' (hsib_body (cid_poly_ty i))
  DerivD _ i -> of' (hsib_body (hswc_body (deriv_type i)))
  _ -> []
  where
    of' (L _ t) = case t of
      HsQualTy _ _ inner -> of' inner
      HsForAllTy _ _ inner -> of' inner
      HsAppTy _ (L _ (HsTyVar _ _ (L _ c))) x -> [(plainName c, n) | Just n <- [constructorOf x]]
      _ -> []
    constructorOf (L _ t) = case t of
      HsParTy _ x -> constructorOf x
      HsAppTy _ f _ -> constructorOf f
      HsTyVar _ _ (L _ n) -> Just (plainName n)
      _ -> Nothing

-- | The type variables that a declaration applies to something.
appliedVariables :: Data a => a -> [String]
appliedVariables x = case cast x of
  Just (HsAppTy _ (L _ f) arg :: HsType GhcPs) -> headVariable f ++ appliedVariables f ++ appliedVariables arg
  _ -> concat (gmapQ appliedVariables x)
  where
    headVariable t = case t of
      HsTyVar _ _ (L _ n) | isTvOcc (rdrNameOcc n) -> [plainName n]
      HsAppTy _ (L _ f) _ -> headVariable f
      HsParTy _ (L _ f) -> headVariable f
      _ -> []

plainName :: RdrName -> String
plainName = occNameString . rdrNameOcc

-- * Names of functions

-- | The library's functions that take a controller: the function that takes its names first, and how many
-- arguments it needs to see ("Rosy.Program" lists them).
naming :: [(String, (String, Int, (LHsExpr GhcPs -> Names) -> [LHsExpr GhcPs] -> [Names]))]
naming =
  [ ("simulate", ("simulateNamed", 1, map)),
    ("task", ("taskNamed", 2, map)),
    ("taskWith", ("taskWithNamed", 2, \name xs -> concat [[field name "starting" o, field name "stopped" o, name c] | [o, c] <- [xs]])),
    ("once", ("onceNamed", 1, map)),
    ("call", ("callNamed", 2, \name xs -> [Names [field name f o | f <- ["cancelOn", "onFeedback", "onEnd"]] | [_, o] <- [xs]]))
  ]
  where
    -- The names in a field of a record that is written out or changed on the spot.
    field name wanted (L _ e) = case e of
      HsPar _ x -> field name wanted x
      RecordUpd {rupd_flds = fs} -> head ([name (hsRecFieldArg f) | L _ f <- fs, plainName (rdrNameAmbiguousFieldOcc (unLoc (hsRecFieldLbl f))) == wanted] ++ [Names []])
      RecordCon {rcon_flds = fs} -> head ([name (hsRecFieldArg f) | L _ f <- rec_flds fs, plainName (unLoc (rdrNameFieldOcc (unLoc (hsRecFieldLbl f)))) == wanted] ++ [Names []])
      _ -> Names []

namingWords :: [String]
namingWords = map fst naming

-- | Replaces the functions of 'naming' where the program does not define the word itself.
nameFunctions :: [String] -> Definitions -> LHsDecl GhcPs -> (LHsDecl GhcPs, [Names])
nameFunctions hidden definitions d = (walk d, found d)
  where
    -- What is written out in this declaration is called like it.
    owner = case unLoc d of
      ValD _ b | n : _ <- collectHsBindBinders b -> plainName n
      _ -> "main"
    table = [entry | entry@(n, _) <- naming, n `notElem` hidden]

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
      HsPar x inner -> L at (HsPar x (expression follows inner))
      HsVar {} -> spine follows l
      _ -> L at (gmapT walk e)

    uses :: Maybe (LHsExpr GhcPs) -> LHsExpr GhcPs -> [Names]
    uses follows l@(L _ e) = case e of
      OpApp _ a op b -> uses (afterDollar op b) a ++ uses follows b
      HsPar _ inner -> uses follows inner
      HsApp {} -> use follows l ++ concatMap (uses Nothing) (arguments l)
      HsVar {} -> use follows l
      _ -> concat (gmapQ found e)

    use follows l = maybe [] snd (namedFunction follows l)

    spine follows l = rebuild l
      where
        replacement = namedFunction follows l
        rebuild (L at e) = case e of
          HsApp x f a -> L at (HsApp x (rebuild f) (expression Nothing a))
          HsPar x inner | isHead inner -> L at (HsPar x (rebuild inner))
          HsVar {} | Just (f, names) <- replacement -> L at (HsPar noExtField (foldl (\g n -> L at (HsApp noExtField g (namesExpression n))) (L at (HsVar noExtField (L at (added (mkVarOcc f))))) names))
          HsVar {} -> L at e
          _ -> expression Nothing (L at e)
        isHead (L _ e) = case e of
          HsApp {} -> True
          HsVar {} -> True
          HsPar _ inner -> isHead inner
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
    applied (L _ (HsPar _ x)) args = applied x args
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
  Name s -> nlHsApp (constructor "Name") (noLoc (HsLit noExtField (HsString NoSourceText (mkFastString s))))
  Names ns -> nlHsApp (constructor "Names") (nlList (map namesExpression ns))
  where
    constructor c = nlHsVar (added (mkDataOcc c))

-- * Looking through the tree

-- | Every binding of the program, local ones included where that is asked for; top-level ones win when a name is bound twice.
allBinds :: (LHsDecl GhcPs -> Bool) -> HsModule -> [LHsBind GhcPs]
allBinds within m = localOnes ++ topOnes
  where
    topOnes = [L at b | L at (ValD _ b) <- hsmodDecls m]
    localOnes = concat [nested (L at b) | d@(L at (ValD _ b)) <- hsmodDecls m, within d]
    nested :: Data a => a -> [LHsBind GhcPs]
    nested x = concat (gmapQ here x)
    here :: Data a => a -> [LHsBind GhcPs]
    here x = case cast x of
      Just (HsValBinds _ (ValBinds _ binds _) :: HsLocalBinds GhcPs) -> bagToList binds ++ concatMap nested (bagToList binds)
      _ -> nested x

-- | Every variable that a pattern binds.
variables :: Data a => a -> [OccName]
variables x = case cast x of
  Just (VarPat _ (L _ n) :: Pat GhcPs) -> [rdrNameOcc n]
  _ -> concat (gmapQ variables x)
