{-# LANGUAGE GADTs #-}
{-# LANGUAGE RankNTypes #-}
{-# LANGUAGE ScopedTypeVariables #-}

-- |
-- Module      : Rosy.Worker.Ghc.DeclaredTypes
-- Description : Instances of the types that a program declares: how those are derived that it asks for, and those that are added.
--
-- "Rosy.Program" says what is added.
module Rosy.Worker.Ghc.DeclaredTypes
  ( InstanceBodies (..),
    withStrategies,
    instancesFor,
    instanceHead,
    ownDefaults,

    -- * Names
    generatedQualifier,
    added,
    plainName,
  )
where

import Data.Data (Data, gmapQ)
import Data.Maybe (fromMaybe, isNothing)
import Data.Typeable (cast)
import GHC (mkModuleName)
import GHC.Hs
import GHC.Types.Name.Occurrence
import GHC.Types.Name.Reader (RdrName, mkRdrQual, mkRdrUnqual, rdrNameOcc)
import GHC.Types.SrcLoc
import Rosy.Worker.Ghc.Compat.Declarations
import Rosy.Worker.Ghc.Compat.Syntax

-- | Qualifier of generated names; not a valid module name in source text.
generatedQualifier :: String
generatedQualifier = "$rosy"

added :: OccName -> RdrName
added = mkRdrQual (mkModuleName generatedQualifier)

-- | Bodies of generated instances: from the type's structure, or empty. Empty bodies suffice for type checking and take a tenth of
-- the time; code compiled with them never runs.
data InstanceBodies = WholeBodies | EmptyBodies
  deriving (Eq)

-- * Deriving

-- | States how each class without a strategy is derived. Of GHC's choices for a newtype, @anyclass@ takes precedence where it is enabled, and leaves
-- @Num@ without methods; here the representation's instance does. The classes of Rosy need no deriving: 'instancesFor' adds them.
withStrategies :: [LHsDecl GhcPs] -> [LHsDecl GhcPs]
withStrategies everything = [L at (decided d) | L at d <- everything]
  where
    decided :: HsDecl GhcPs -> HsDecl GhcPs
    decided d = case d of
      TyClD x t@DataDecl {tcdDataDefn = defn} -> TyClD x t {tcdDataDefn = decideDerivations (clause (isNewtype defn)) defn}
      DerivD x s -> DerivD x (decideStandalone standalone s)
      _ -> d
    newtypes = [plainName (unLoc (tcdLName t)) | L _ (TyClD _ t@DataDecl {tcdDataDefn = defn}) <- everything, isNewtype defn]
    clause ofNewtype stated c
      | stated `elem` [Unstated, ByClassDefaults], name `elem` addedClasses = Nothing
      | stated == Unstated, ofNewtype = Just (ofRepresentation name)
      | otherwise = Just stated
      where
        name = maybe "" plainName (headOf c)
    standalone stated t
      | stated == Unstated, (c, n) : _ <- classAndType t, n `elem` newtypes = ofRepresentation c
      | otherwise = stated
    -- What GHC derives from the structure, or from the representation, without being told.
    ofRepresentation name
      | name `elem` ["Eq", "Ord", "Ix", "Bounded", "Show", "Read", "Data", "Lift", "Typeable", "Generic", "Generic1", "Functor", "Foldable", "Traversable"] = Unstated
      | otherwise = ByRepresentation
    headOf :: LHsType GhcPs -> Maybe RdrName
    headOf (L _ t) = case t of
      HsTyVar _ _ (L _ n) -> Just n
      HsAppTy _ f _ -> headOf f
      HsParTy _ x -> headOf x
      _ -> Nothing

-- | The classes whose instances are added to every declared type.
addedClasses :: [String]
addedClasses = map fst addedMethods

addedMethods :: [(String, [String])]
addedMethods = [("Value", ["display", "settle", "initial"]), ("Default", ["defaultValue"]), ("Sensor", ["sensor"]), ("Command", ["command"])]

-- * Instances

-- | The instances that make a declared type an event of its own ("Rosy.Program" says which). Their location is that of the
-- declaration, so an error in an instance is reported there.
instancesFor :: InstanceBodies -> [LHsDecl GhcPs] -> LHsDecl GhcPs -> [LHsDecl GhcPs]
instancesFor instances everything (At at d) = case d of
  TyClD _ t@DataDecl {tcdDataDefn = defn}
    | Just structure <- structureOf everything defn ->
      let methodsOf c methods
            | instances == EmptyBodies = [method m m | m <- methods]
            | c == "Value" = structureMethods at structure
            | otherwise = []
       in concat [with (methodsOf c methods) t c | (c, methods) <- addedMethods, not (derives c defn)]
    | isNothing (dd_kindSig defn) ->
      -- Their values can be sent, but have no default.
      concat [with [method m f | (m, f) <- methods] t c | (c, methods) <- [("Value", opaqueMethods), ("Sensor", sameWhenChecked "sensor"), ("Command", sameWhenChecked "command")], not (derives c defn)]
    where
      opaqueMethods = [("display", "displayOpaque"), ("settle", "settleOpaque"), ("initial", "initialOpaque")]
      sameWhenChecked m = [(m, m) | instances == EmptyBodies]
  _ -> []
  where
    derives :: String -> HsDataDefn GhcPs -> Bool
    derives wanted defn = wanted `elem` map plainName (derivedClasses defn)
    -- The program's own instance is the better one.
    has :: String -> TyClDecl GhcPs -> Bool
    has wanted t = (wanted, plainName (unLoc (tcdLName t))) `elem` concatMap (instanceHead . unLoc) everything
    method m f = methodOf at m [] (addedFunction f)
    with binds t c = [classInstance at (headOf c t) binds | not (has c t)]
    headOf :: String -> TyClDecl GhcPs -> LHsSigType GhcPs
    headOf c t = sigType (inContext t (At at (HsAppTy noExtField (name (added (mkTcOcc c))) (applied t))))
    inContext :: TyClDecl GhcPs -> LHsType GhcPs -> LHsType GhcPs
    inContext t body
      | null (parameters t) = body
      | otherwise = At at (HsQualTy noExtField (At at [At at (HsAppTy noExtField (name (added (mkTcOcc (classFor t v)))) (name v)) | v <- parameters t]) body)
    -- What a parameter must be: something to hold, or something that holds others.
    classFor :: TyClDecl GhcPs -> RdrName -> String
    classFor t v = if plainName v `elem` appliedVariables (tcdDataDefn t) || isNothing (structureOf everything (tcdDataDefn t)) then "Typeable" else "Value"
    parameters :: TyClDecl GhcPs -> [RdrName]
    parameters t = map hsLTyVarName (hsQTvExplicit (tcdTyVars t))
    applied :: TyClDecl GhcPs -> LHsType GhcPs
    applied t = case parameters t of
      [] -> name (unLoc (tcdLName t))
      vs -> parenType at (foldl (\f v -> At at (HsAppTy noExtField f (name v))) (name (unLoc (tcdLName t))) vs)
    name :: RdrName -> LHsType GhcPs
    name = typeVariable at

-- | A constructor with as many variables as fields, and its labels if it has any. One with a precedence is infix.
data Constructor = Constructor RdrName (Maybe Int) [String] [RdrName]

-- | The constructors of a type, if none has type variables, constraints or polymorphic fields of its own.
structureOf :: [LHsDecl GhcPs] -> HsDataDefn GhcPs -> Maybe [Constructor]
structureOf everything defn
  | not (all (isPlainConstructor . unLoc) constructors) || hasInnerTypes constructors = Nothing
  | otherwise = Just (concatMap (ofConstructor . unLoc) constructors)
  where
    constructors = dataConstructors defn
    fixities = fixityDeclarations everything
    ofConstructor :: ConDecl GhcPs -> [Constructor]
    ofConstructor c = [withForm n (constructorForm c) | n <- constructorNames c]
    withForm n form = case form of
      RecordForm labels -> Constructor n Nothing labels (variables (length labels))
      InfixForm -> Constructor n (Just (precedence n)) [] (variables 2)
      -- In GADT syntax an operator with two fields is infix if it has a precedence.
      PrefixForm 2 | isSymOcc (rdrNameOcc n), isGadt -> Constructor n (lookup n fixities) [] (variables 2)
      PrefixForm count -> Constructor n Nothing [] (variables count)
    isGadt = any (\(L _ c) -> case c of ConDeclGADT {} -> True; _ -> False) constructors
    -- That of an operator without a declaration.
    precedence n = fromMaybe 9 (lookup n fixities)
    variables :: Int -> [RdrName]
    variables count = [mkRdrUnqual (mkVarOcc ("field" ++ show i)) | i <- [1 .. count]]

-- | The methods of @Value@ of a type with this structure.
structureMethods :: SrcSpan -> [Constructor] -> [LHsBind GhcPs]
structureMethods at structure =
  [ methodOf at "parts" [nlVarPat value] (nlHsCase (nlHsVar value) [mkHsCaseAlt (nlConVarPat c vars) (takenApart constructor) | constructor@(Constructor c _ _ vars) <- structure]),
    methodOf at "display" [] (addedFunction "displayParts"),
    methodOf at "settle" [] (addedFunction "settleParts"),
    methodOf at "initial" [] (nlHsApp (addedFunction "initialFrom") (nlList (map begun structure)))
  ]
  where
    value = mkRdrUnqual (mkVarOcc "value")
    takenApart (Constructor c infixPrecedence labels vars) = case infixPrecedence of
      Nothing -> applying (addedConstructor "Parts") [stringLiteral (plainName c), nlList (map stringLiteral labels), nlList (map field vars)]
      Just precedence -> applying (addedConstructor "InfixParts") (nlHsIntLit (toInteger precedence) : stringLiteral (plainName c) : map field vars)
    field = nlHsApp (addedConstructor "Field") . nlHsVar
    begun (Constructor c _ _ vars) = foldl (\part _ -> nlHsApp (addedFunction "withField") part) (nlHsApp (addedFunction "construct") (nlHsVar c)) vars
    applying = foldl nlHsApp
    addedConstructor = nlHsVar . added . mkDataOcc

methodOf :: SrcSpan -> String -> [LPat GhcPs] -> LHsExpr GhcPs -> LHsBind GhcPs
methodOf at = mkSimpleGeneratedFunBind at . mkRdrUnqual . mkVarOcc

addedFunction :: String -> LHsExpr GhcPs
addedFunction = nlHsVar . added . mkVarOcc

-- | Whether there are types with variables of their own inside.
hasInnerTypes :: Data a => a -> Bool
hasInnerTypes x = case cast x of
  Just (HsForAllTy {} :: HsType GhcPs) -> True
  Just HsQualTy {} -> True
  _ -> or (gmapQ hasInnerTypes x)

instanceHead :: HsDecl GhcPs -> [(String, String)]
instanceHead d = case d of
  InstD _ (ClsInstD _ i) -> classAndType (sigBody (cid_poly_ty i))
  DerivD _ i -> classAndType (sigBody (hswc_body (deriv_type i)))
  _ -> []

-- | The class and the type constructor of an instance head.
classAndType :: LHsType GhcPs -> [(String, String)]
classAndType = of'
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

-- | The types whose default the program defines itself.
ownDefaults :: SyntaxTree -> [String]
ownDefaults parsed = [t | L _ d <- hsmodDecls parsed, (c, t) <- instanceHead d, c `elem` ["Default", "Value"]]

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
