{-# LANGUAGE CPP #-}
{-# LANGUAGE FlexibleContexts #-}
{-# LANGUAGE FlexibleInstances #-}
{-# LANGUAGE PatternSynonyms #-}
{-# LANGUAGE ScopedTypeVariables #-}
{-# LANGUAGE TypeFamilies #-}
{-# LANGUAGE UndecidableInstances #-}
-- Which module exports a name differs between versions.
{-# OPTIONS_GHC -Wno-unused-imports #-}

{- HLINT ignore "Unused LANGUAGE pragma" -}

-- |
-- Module      : Rosy.Worker.Ghc.Compat.Declarations
-- Description : Compatibility layer over the declarations and imports of a program.
module Rosy.Worker.Ghc.Compat.Declarations
  ( constructorNames,
    constructorFields,
    ConstructorForm (..),
    constructorForm,
    fixityDeclarations,
    isPlainConstructor,
    dataConstructors,
    isNewtype,
    derivedClasses,
    Derivation (..),
    decideDerivations,
    decideStandalone,
    classInstance,
    emptyDefault,

    -- * Imports
    implicitImport,
    importList,
    withImportList,
    importValue,
    importType,
    importPattern,
  )
where

import Data.Data (Data, cast, gmapQ)
import Data.Foldable (toList)
import Data.List (nub)
import GHC.Hs
import GHC.Types.Name.Occurrence (occNameString)
import GHC.Types.Name.Reader (RdrName, isRdrTyVar, rdrNameOcc)
import GHC.Types.SrcLoc
import GHC.Unit.Module (mkModuleName)
#if __GLASGOW_HASKELL__ >= 904
import GHC.Parser.Annotation
import GHC.Types.Fixity (Fixity (..))
#else
import GHC.Types.Basic (Fixity (..))
#endif
import Rosy.Worker.Ghc.Compat.Syntax

constructorNames :: ConDecl GhcPs -> [RdrName]
constructorNames c = case c of
  ConDeclH98 {con_name = L _ n} -> [n]
  ConDeclGADT {con_names = ns} -> map unLoc (toList ns)

constructorFields :: ConDecl GhcPs -> [RdrName]

-- | How a constructor is declared: before so many fields, with these labels, or between its two fields.
data ConstructorForm = PrefixForm Int | RecordForm [String] | InfixForm
  deriving (Eq)

constructorForm :: ConDecl GhcPs -> ConstructorForm
constructorForm c = case map (occNameString . rdrNameOcc) (constructorFields c) of
  [] -> maybe InfixForm PrefixForm (positionalFields c)
  labels -> RecordForm labels

-- | The number of fields of a constructor without labels; 'Nothing' for an infix one.
positionalFields :: ConDecl GhcPs -> Maybe Int

-- | The precedences that the program declares.
fixityDeclarations :: [LHsDecl GhcPs] -> [(RdrName, Int)]
fixityDeclarations everything = [(n, precedence) | L _ (SigD _ (FixSig _ (FixitySig _ names (Fixity _ precedence _)))) <- everything, L _ n <- names]

-- | Whether a constructor has no type variables and constraints of its own.
isPlainConstructor :: ConDecl GhcPs -> Bool
#if __GLASGOW_HASKELL__ >= 904
constructorFields c = case c of
  ConDeclH98 {con_args = RecCon (L _ fs)} -> concatMap fieldNames fs
  ConDeclGADT {con_g_args = RecordArguments (L _ fs)} -> concatMap fieldNames fs
  _ -> []

fieldNames :: LConDeclField GhcPs -> [RdrName]
fieldNames (L _ f) = [unLoc (foLabel n) | L _ n <- cd_fld_names f]

positionalFields c = case c of
  ConDeclH98 {con_args = PrefixArguments xs} -> Just (length xs)
  ConDeclH98 {con_args = InfixCon _ _} -> Nothing
  ConDeclGADT {con_g_args = GadtArguments xs} -> Just (length xs)
  _ -> Just 0

isPlainConstructor c = case c of
  ConDeclH98 {con_forall = False, con_mb_cxt = Nothing} -> True
  ConDeclGADT {con_mb_cxt = Nothing, con_res_ty = result} -> hasOnlyVariablesOf result c
  _ -> False

#else
constructorFields c = case c of
  ConDeclH98 {con_args = RecCon (L _ fs)} -> concatMap fieldNames fs
  ConDeclGADT {con_args = RecCon (L _ fs)} -> concatMap fieldNames fs
  _ -> []

fieldNames :: LConDeclField GhcPs -> [RdrName]
fieldNames (L _ f) = [unLoc (rdrNameFieldOcc n) | L _ n <- cd_fld_names f]

positionalFields c = case con_args c of
  PrefixArguments xs -> Just (length xs)
  InfixCon _ _ -> Nothing
  RecCon _ -> Just 0

isPlainConstructor c = case c of
  ConDeclH98 {con_forall = L _ False, con_mb_cxt = Nothing} -> True
  ConDeclGADT {con_mb_cxt = Nothing, con_res_ty = result} -> hasOnlyVariablesOf result c
  _ -> False

#endif
#if __GLASGOW_HASKELL__ >= 910
pattern RecordArguments :: XRec GhcPs [LConDeclField GhcPs] -> HsConDeclGADTDetails GhcPs
pattern RecordArguments fs <- RecConGADT _ fs

pattern GadtArguments :: [HsScaled GhcPs (LBangType GhcPs)] -> HsConDeclGADTDetails GhcPs
pattern GadtArguments xs <- PrefixConGADT _ xs
#elif __GLASGOW_HASKELL__ >= 904
pattern RecordArguments :: XRec GhcPs [LConDeclField GhcPs] -> HsConDeclGADTDetails GhcPs
pattern RecordArguments fs <- RecConGADT fs _

pattern GadtArguments :: [HsScaled GhcPs (LBangType GhcPs)] -> HsConDeclGADTDetails GhcPs
pattern GadtArguments xs <- PrefixConGADT xs
#endif

-- | Whether the result of a constructor in GADT syntax is the declared type applied to different variables, and has all variables of its fields.
hasOnlyVariablesOf :: LHsType GhcPs -> ConDecl GhcPs -> Bool
hasOnlyVariablesOf result c = maybe False (\vs -> nub vs == vs && all (`elem` vs) (variables c)) (arguments result)
  where
    arguments :: LHsType GhcPs -> Maybe [RdrName]
    arguments (L _ t) = case t of
      HsAppTy _ f (L _ (HsTyVar _ _ (L _ v))) | isRdrTyVar v -> (++ [v]) <$> arguments f
      HsParTy _ x -> arguments x
      HsTyVar _ _ (L _ v) | not (isRdrTyVar v) -> Just []
      _ -> Nothing
    variables :: Data a => a -> [RdrName]
    variables x = case cast x of
      Just (HsTyVar _ _ (L _ v) :: HsType GhcPs) | isRdrTyVar v -> [v]
      _ -> concat (gmapQ variables x)

dataConstructors :: HsDataDefn GhcPs -> [LConDecl GhcPs]
dataConstructors = toList . dd_cons

isNewtype :: HsDataDefn GhcPs -> Bool
#if __GLASGOW_HASKELL__ >= 906
isNewtype defn = case dd_cons defn of
  NewTypeCon _ -> True
  DataTypeCons _ _ -> False
#else
isNewtype defn = dd_ND defn == NewType
#endif

-- | The classes in the deriving clauses of a data type.
derivedClasses :: HsDataDefn GhcPs -> [RdrName]
#if __GLASGOW_HASKELL__ >= 904
derivedClasses defn = [n | L _ clause <- dd_derivs defn, t <- types (unLoc (deriv_clause_tys clause)), L _ (HsTyVar _ _ (L _ n)) <- [sigBody t]]
  where
    types clause = case clause of
      DctSingle _ t -> [t]
      DctMulti _ ts -> ts
      _ -> []
#else
derivedClasses defn = [n | L _ clause <- unLoc (dd_derivs defn), t <- unLoc (deriv_clause_tys clause), L _ (HsTyVar _ _ (L _ n)) <- [sigBody t]]
#endif

-- | How an instance is derived: a strategy that the program states, or none.
data Derivation = Unstated | ByStructure | ByClassDefaults | ByRepresentation
  deriving (Eq)

-- | Decides for each class of the deriving clauses of a data type: derived by another strategy than the stated one, or not at all.
decideDerivations :: (Derivation -> LHsType GhcPs -> Maybe Derivation) -> HsDataDefn GhcPs -> HsDataDefn GhcPs

-- | The same for a standalone deriving declaration.
decideStandalone :: (Derivation -> LHsType GhcPs -> Derivation) -> DerivDecl GhcPs -> DerivDecl GhcPs
decideStandalone decide d = d {deriv_strategy = reviseStrategy (\s -> decide s (sigBody (hswc_body (deriv_type d)))) (deriv_strategy d)}

reviseStrategy :: (Derivation -> Derivation) -> Maybe (LDerivStrategy GhcPs) -> Maybe (LDerivStrategy GhcPs)
reviseStrategy decide stated = case derivation stated of
  Just d | d' <- decide d, d' /= d -> strategyOf d'
  _ -> stated

-- | The strategy that is stated; 'Nothing' for @via@.
derivation :: Maybe (LDerivStrategy GhcPs) -> Maybe Derivation
derivation stated = case fmap unLoc stated of
  Nothing -> Just Unstated
  Just StockStrategy {} -> Just ByStructure
  Just AnyclassStrategy {} -> Just ByClassDefaults
  Just NewtypeStrategy {} -> Just ByRepresentation
  Just ViaStrategy {} -> Nothing

strategyOf :: Derivation -> Maybe (LDerivStrategy GhcPs)
#if __GLASGOW_HASKELL__ >= 904
strategyOf d = case d of
  Unstated -> Nothing
  ByStructure -> Just (node (StockStrategy noAnn))
  ByClassDefaults -> Just (node (AnyclassStrategy noAnn))
  ByRepresentation -> Just (node (NewtypeStrategy noAnn))
decideDerivations decide defn = defn {dd_derivs = concatMap clause (dd_derivs defn)}
  where
    clause l@(L at c) = case derivation (deriv_clause_strategy c) of
      Nothing -> [l]
      Just stated -> [L at c {deriv_clause_strategy = if d == stated then deriv_clause_strategy c else strategyOf d, deriv_clause_tys = classes ts (deriv_clause_tys c)} | (d, ts) <- grouped decide stated (types (unLoc (deriv_clause_tys c)))]
    types :: DerivClauseTys GhcPs -> [LHsSigType GhcPs]
    types c = case c of
      DctSingle _ t -> [t]
      DctMulti _ ts -> ts
    classes ts (L at _) = L at (DctMulti noExtField ts)
#else
strategyOf d = case d of
  Unstated -> Nothing
  ByStructure -> Just (node StockStrategy)
  ByClassDefaults -> Just (node AnyclassStrategy)
  ByRepresentation -> Just (node NewtypeStrategy)
decideDerivations decide defn = defn {dd_derivs = concatMap clause <$> dd_derivs defn}
  where
    clause l@(L at c) = case derivation (deriv_clause_strategy c) of
      Nothing -> [l]
      Just stated -> [L at c {deriv_clause_strategy = if d == stated then deriv_clause_strategy c else strategyOf d, deriv_clause_tys = ts <$ deriv_clause_tys c} | (d, ts) <- grouped decide stated (unLoc (deriv_clause_tys c))]
#endif

-- | The classes of one clause by their derivation, in order.
grouped :: (Derivation -> LHsType GhcPs -> Maybe Derivation) -> Derivation -> [LHsSigType GhcPs] -> [(Derivation, [LHsSigType GhcPs])]
grouped decide stated ts = [(d, here) | d <- [Unstated, ByStructure, ByClassDefaults, ByRepresentation], here@(_ : _) <- [[t | t <- ts, decide stated (sigBody t) == Just d]]]

-- | A class instance with these methods.
classInstance :: SrcSpan -> LHsSigType GhcPs -> [LHsBind GhcPs] -> LHsDecl GhcPs
#if __GLASGOW_HASKELL__ >= 908
classInstance at t methods = At at (InstD noExtField (ClsInstD noExtField (ClsInstDecl (Nothing, noAnn, NoAnnSortKey) t (bindBag methods) [] [] [] Nothing)))
#elif __GLASGOW_HASKELL__ >= 904
classInstance at t methods = At at (InstD noExtField (ClsInstD noExtField (ClsInstDecl (noAnn, NoAnnSortKey) t (bindBag methods) [] [] [] Nothing)))
#else
classInstance at t methods = At at (InstD noExtField (ClsInstD noExtField (ClsInstDecl noExtField t (bindBag methods) [] [] [] Nothing)))
#endif

-- | @default ()@.
emptyDefault :: LHsDecl GhcPs
#if __GLASGOW_HASKELL__ >= 904
emptyDefault = node (DefD noExtField (DefaultDecl noAnn []))
#else
emptyDefault = node (DefD noExtField (DefaultDecl noExtField []))
#endif

-- * Imports

-- | An import that the program does not contain.
implicitImport :: String -> ImportDecl GhcPs
#if __GLASGOW_HASKELL__ >= 906
implicitImport m = i {ideclExt = (ideclExt i) {ideclImplicit = True}}
  where
    i = simpleImportDecl (mkModuleName m)
#else
implicitImport m = (simpleImportDecl (mkModuleName m)) {ideclImplicit = True}
#endif

-- | The import list: whether it hides its names, its span, and its items.
importList :: ImportDecl GhcPs -> Maybe (Bool, SrcSpan, [LIE GhcPs])
withImportList :: Bool -> SrcSpan -> [LIE GhcPs] -> ImportDecl GhcPs -> ImportDecl GhcPs
#if __GLASGOW_HASKELL__ >= 906
importList i = (\(how, At s items) -> (how == EverythingBut, s, items)) <$> ideclImportList i
withImportList hides s items i = i {ideclImportList = Just (if hides then EverythingBut else Exactly, At s items)}
#else
importList i = (\(hides, At s items) -> (hides, s, items)) <$> ideclHiding i
withImportList hides s items i = i {ideclHiding = Just (hides, At s items)}
#endif

importValue, importType, importPattern :: RdrName -> LIE GhcPs
#if __GLASGOW_HASKELL__ >= 910
importValue n = node (IEVar Nothing (node (IEName noExtField (node n))) Nothing)
importType n = node (IEThingAbs (Nothing, noAnn) (node (IEName noExtField (node n))) Nothing)
importPattern n = node (IEVar Nothing (node (IEPattern noAnn (node n))) Nothing)
#elif __GLASGOW_HASKELL__ >= 906
importValue n = node (IEVar noExtField (node (IEName noExtField (node n))))
importType n = node (IEThingAbs noAnn (node (IEName noExtField (node n))))
importPattern n = node (IEVar noExtField (node (IEPattern noAnchor' (node n))))
  where
    noAnchor' = EpaDelta (SameLine 0) []
#elif __GLASGOW_HASKELL__ >= 904
importValue n = node (IEVar noExtField (node (IEName (node n))))
importType n = node (IEThingAbs noAnn (node (IEName (node n))))
importPattern n = node (IEVar noExtField (node (IEPattern (EpaDelta (SameLine 0) []) (node n))))
#else
importValue n = node (IEVar noExtField (node (IEName (node n))))
importType n = node (IEThingAbs noExtField (node (IEName (node n))))
importPattern n = node (IEVar noExtField (node (IEPattern (node n))))
#endif
