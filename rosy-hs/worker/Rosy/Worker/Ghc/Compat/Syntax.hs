{-# LANGUAGE CPP #-}
{-# LANGUAGE FlexibleContexts #-}
{-# LANGUAGE FlexibleInstances #-}
{-# LANGUAGE PatternSynonyms #-}
{-# LANGUAGE ScopedTypeVariables #-}
{-# LANGUAGE TupleSections #-}
{-# LANGUAGE TypeFamilies #-}
{-# LANGUAGE UndecidableInstances #-}
{-# LANGUAGE ViewPatterns #-}
-- Which module exports a name differs between versions.
{-# OPTIONS_GHC -Wno-unused-imports #-}

-- |
-- Module      : Rosy.Worker.Ghc.Compat.Syntax
-- Description : Compatibility layer over GHC's syntax trees, for GHC 9.0, 9.4, 9.6 and newer.
--
-- Patterns and builders for every tree node whose constructor differs between versions. Callers are written once.
module Rosy.Worker.Ghc.Compat.Syntax
  ( SyntaxTree,

    -- * Locations
    Location (..),
    pattern At,
    node,
    spanOf,

    -- * Expressions
    pattern Paren,
    pattern LetIn,
    pattern Lambda,
    pattern LambdaCase,
    pattern ListOf,
    pattern TypeApplied,
    paren,
    application,
    variableExpression,
    typedExpression,
    stringLiteral,
    integerLiteral,
    letIn,
    updatedFields,
    tupleParts,
    letStatement,

    -- * Patterns and bindings
    pattern ParenPattern,
    pattern AsPattern,
    pattern PrefixArguments,
    recordArguments,
    localBindings,
    boundNames,
    bindList,
    bindBag,

    -- * Declarations
    constructorNames,
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
    sigBody,
    sigType,
    typeVariable,
    parenType,
    classInstance,
    emptyDefault,

    -- * Imports
    implicitImport,
    importList,
    withImportList,
    importValue,
    importType,
    importPattern,

    -- * The typed tree
    pattern Abstraction,
    pattern ConstructorExpression,
    pattern FieldSelector,
    pattern Expansion,
    hsLitType,
    listType,
    recordConstructor,
    intLiteral,
  )
where

import Data.Data (Data, cast, gmapQ)
import Data.Foldable (toList)
import Data.List (nub)
import GHC.Builtin.Types (mkListTy)
import GHC.Core.ConLike (ConLike (..))
import GHC.Core.DataCon (DataCon)
import GHC.Core.TyCo.Rep (Type)
import GHC.Data.Bag (Bag, bagToList, listToBag)
import GHC.Hs
import GHC.Types.Id (Id)
import GHC.Types.Name.Occurrence (occNameString)
import GHC.Types.Name.Reader (RdrName, isRdrTyVar, rdrNameOcc)
import GHC.Types.SrcLoc
import GHC.Unit.Module (mkModuleName)
#if __GLASGOW_HASKELL__ >= 904
import GHC.Hs.Syn.Type (hsLitType)
import GHC.Parser.Annotation
import GHC.Types.Basic (PromotionFlag (NotPromoted))
import GHC.Types.Fixity (Fixity (..))
import GHC.Types.SourceText (IntegralLit (il_value), mkIntegralLit)
#else
import GHC.Types.Basic (Fixity (..), IntegralLit (il_value), PromotionFlag (NotPromoted), mkIntegralLit)
import GHC.Tc.Utils.Zonk (hsLitType)
#endif

-- | The tree of a whole program.
#if __GLASGOW_HASKELL__ >= 906
type SyntaxTree = HsModule GhcPs
#else
type SyntaxTree = HsModule
#endif

-- * Locations

-- | Locations of tree nodes: plain spans in GHC 9.0, spans with annotations later.
class Location l where
  toSpan :: l -> SrcSpan
  fromSpan :: SrcSpan -> l

instance Location SrcSpan where
  toSpan = id
  fromSpan = id

#if __GLASGOW_HASKELL__ >= 910
instance NoAnn a => Location (EpAnn a) where
  toSpan = locA
  fromSpan = noAnnSrcSpan
#elif __GLASGOW_HASKELL__ >= 904
instance Location (SrcSpanAnn' (EpAnn a)) where
  toSpan = locA
  fromSpan = noAnnSrcSpan
#endif

-- | A node with its span.
pattern At :: Location l => SrcSpan -> e -> GenLocated l e
pattern At s e <-
  L (toSpan -> s) e
  where
    At s e = L (fromSpan s) e

{-# COMPLETE At #-}

-- | A generated node, without a span.
node :: Location l => e -> GenLocated l e
node = At noSrcSpan

spanOf :: Location l => GenLocated l e -> SrcSpan
spanOf (L l _) = toSpan l

-- * Expressions

pattern Paren :: LHsExpr (GhcPass p) -> HsExpr (GhcPass p)

pattern LetIn :: HsLocalBinds (GhcPass p) -> LHsExpr (GhcPass p) -> HsExpr (GhcPass p)

pattern Lambda, LambdaCase :: MatchGroup (GhcPass p) (LHsExpr (GhcPass p)) -> HsExpr (GhcPass p)

pattern ListOf :: [LHsExpr (GhcPass p)] -> HsExpr (GhcPass p)

pattern TypeApplied :: LHsExpr (GhcPass p) -> HsExpr (GhcPass p)

#if __GLASGOW_HASKELL__ >= 910
pattern Paren e <- HsPar _ e
pattern LetIn b e <- HsLet _ b e
pattern Lambda m <- HsLam _ LamSingle m
pattern LambdaCase m <- HsLam _ LamCase m
#elif __GLASGOW_HASKELL__ >= 904
pattern Paren e <- HsPar _ _ e _
pattern LetIn b e <- HsLet _ _ b _ e
pattern Lambda m <- HsLam _ m
pattern LambdaCase m <- HsLamCase _ LamCase m
#else
pattern Paren e <- HsPar _ e
pattern LetIn b e <- HsLet _ (L _ b) e
pattern Lambda m <- HsLam _ m
pattern LambdaCase m <- HsLamCase _ m
#endif

#if __GLASGOW_HASKELL__ >= 904
pattern ListOf es <- ExplicitList _ es
#else
pattern ListOf es <- ExplicitList _ _ es
#endif

#if __GLASGOW_HASKELL__ >= 906 && __GLASGOW_HASKELL__ < 910
pattern TypeApplied e <- HsAppType _ e _ _
#else
pattern TypeApplied e <- HsAppType _ e _
#endif

-- | An expression in parentheses.
paren :: SrcSpan -> LHsExpr GhcPs -> LHsExpr GhcPs
paren at e = At at (unLoc (nlHsPar e))

-- | A function applied to an argument, without added parentheses.
application :: SrcSpan -> LHsExpr GhcPs -> LHsExpr GhcPs -> LHsExpr GhcPs
#if __GLASGOW_HASKELL__ >= 910
application at f x = At at (HsApp noExtField f x)
#elif __GLASGOW_HASKELL__ >= 904
application at f x = At at (HsApp noComments f x)
#else
application at f x = At at (HsApp noExtField f x)
#endif

variableExpression :: SrcSpan -> RdrName -> LHsExpr GhcPs
variableExpression at n = At at (HsVar noExtField (At at n))

-- | An expression with its type.
typedExpression :: LHsExpr GhcPs -> LHsType GhcPs -> LHsExpr GhcPs
#if __GLASGOW_HASKELL__ >= 904
typedExpression e t = node (ExprWithTySig noAnn e (mkHsWildCardBndrs (sigType t)))
#else
typedExpression e t = node (ExprWithTySig noExtField e (mkHsWildCardBndrs (sigType t)))
#endif

stringLiteral :: String -> LHsExpr GhcPs
stringLiteral = nlHsLit . mkHsString

-- | The value of an integer that is written out.
integerLiteral :: HsExpr GhcPs -> Maybe Integer
integerLiteral e = case e of
  HsOverLit _ OverLit {ol_val = HsIntegral n} -> Just (il_value n)
  _ -> Nothing

-- | A @let@ expression.
letIn :: HsLocalBinds GhcPs -> LHsExpr GhcPs -> LHsExpr GhcPs
#if __GLASGOW_HASKELL__ >= 910
letIn b e = At (spanOf e) (HsLet noAnn b e)
#elif __GLASGOW_HASKELL__ >= 904
letIn b e = At (spanOf e) (HsLet noAnn noHsTok b noHsTok e)
#else
letIn b e = At (getLoc e) (HsLet noExtField (noLoc b) e)
#endif

-- | The fields of a record construction or update, with their values.
updatedFields :: HsExpr GhcPs -> Maybe [(RdrName, LHsExpr GhcPs)]
#if __GLASGOW_HASKELL__ >= 908
updatedFields e = case e of
  RecordUpd {rupd_flds = RegularRecUpdFields {recUpdFields = fs}} -> Just [(ambiguousFieldOccRdrName (unLoc (hfbLHS f)), hfbRHS f) | L _ f <- fs]
  RecordCon {rcon_flds = fs} -> Just [(unLoc (foLabel (unLoc (hfbLHS f))), hfbRHS f) | L _ f <- rec_flds fs]
  _ -> Nothing
#elif __GLASGOW_HASKELL__ >= 904
updatedFields e = case e of
  RecordUpd {rupd_flds = Left fs} -> Just [(rdrNameAmbiguousFieldOcc (unLoc (hfbLHS f)), hfbRHS f) | L _ f <- fs]
  RecordCon {rcon_flds = fs} -> Just [(unLoc (foLabel (unLoc (hfbLHS f))), hfbRHS f) | L _ f <- rec_flds fs]
  _ -> Nothing
#else
updatedFields e = case e of
  RecordUpd {rupd_flds = fs} -> Just [(rdrNameAmbiguousFieldOcc (unLoc (hsRecFieldLbl f)), hsRecFieldArg f) | L _ f <- fs]
  RecordCon {rcon_flds = fs} -> Just [(unLoc (rdrNameFieldOcc (unLoc (hsRecFieldLbl f))), hsRecFieldArg f) | L _ f <- rec_flds fs]
  _ -> Nothing
#endif

-- | The parts of a tuple.
#if __GLASGOW_HASKELL__ >= 904
tupleParts :: [HsTupArg p] -> [HsTupArg p]
tupleParts = id
#else
tupleParts :: [LHsTupArg p] -> [HsTupArg p]
tupleParts = map unLoc
#endif

-- | The bindings of a @let@ statement.
#if __GLASGOW_HASKELL__ >= 904
letStatement :: HsLocalBinds (GhcPass p) -> HsLocalBinds (GhcPass p)
letStatement = id
#else
letStatement :: LHsLocalBinds (GhcPass p) -> HsLocalBinds (GhcPass p)
letStatement = unLoc
#endif

-- * Patterns and bindings

pattern ParenPattern :: LPat (GhcPass p) -> Pat (GhcPass p)

pattern AsPattern :: LIdP (GhcPass p) -> LPat (GhcPass p) -> Pat (GhcPass p)

#if __GLASGOW_HASKELL__ >= 910
pattern ParenPattern p <- ParPat _ p
pattern AsPattern v p <- AsPat _ v p
#elif __GLASGOW_HASKELL__ >= 906
pattern ParenPattern p <- ParPat _ _ p _
pattern AsPattern v p <- AsPat _ v _ p
#elif __GLASGOW_HASKELL__ >= 904
pattern ParenPattern p <- ParPat _ _ p _
pattern AsPattern v p <- AsPat _ v p
#else
pattern ParenPattern p <- ParPat _ p
pattern AsPattern v p <- AsPat _ v p
#endif

-- | Positional arguments of a constructor.
#if __GLASGOW_HASKELL__ >= 904
pattern PrefixArguments :: [arg] -> HsConDetails tyarg arg rec
pattern PrefixArguments xs <- PrefixCon _ xs
#else
pattern PrefixArguments :: [arg] -> HsConDetails arg rec
pattern PrefixArguments xs <- PrefixCon xs
#endif

{-# COMPLETE PrefixArguments, RecCon, InfixCon #-}

-- | The patterns of a record pattern's fields.
recordArguments :: HsRecFields (GhcPass p) (LPat (GhcPass p)) -> [LPat (GhcPass p)]
#if __GLASGOW_HASKELL__ >= 904
recordArguments fs = [hfbRHS f | L _ f <- rec_flds fs]
#else
recordArguments fs = [hsRecFieldArg f | L _ f <- rec_flds fs]
#endif

-- | The local bindings of a right-hand side.
localBindings :: GRHSs (GhcPass p) b -> HsLocalBinds (GhcPass p)
#if __GLASGOW_HASKELL__ >= 904
localBindings = grhssLocalBinds
#else
localBindings = unLoc . grhssLocalBinds
#endif

-- | The names bound by a binding.
boundNames :: HsBind GhcPs -> [RdrName]
#if __GLASGOW_HASKELL__ >= 904
boundNames = collectHsBindBinders CollNoDictBinders
#else
boundNames = collectHsBindBinders
#endif

bindList :: Bag a -> [a]
bindList = bagToList

bindBag :: [a] -> Bag a
bindBag = listToBag

-- * Declarations

constructorNames :: ConDecl GhcPs -> [RdrName]
constructorNames c = case c of
  ConDeclH98 {con_name = L _ n} -> [n]
  ConDeclGADT {con_names = ns} -> map unLoc (toList ns)

constructorFields :: ConDecl GhcPs -> [RdrName]

-- | How a constructor is declared: with so many fields behind it, with these labels, or between its two fields.
data ConstructorForm = Positional Int | Labelled [String] | Between
  deriving (Eq)

constructorForm :: ConDecl GhcPs -> ConstructorForm
constructorForm c = case map (occNameString . rdrNameOcc) (constructorFields c) of
  [] -> maybe Between Positional (positionalFields c)
  labels -> Labelled labels

-- | The number of fields of a constructor without labels; 'Nothing' for one between its fields.
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

sigBody :: LHsSigType GhcPs -> LHsType GhcPs
sigType :: LHsType GhcPs -> LHsSigType GhcPs
#if __GLASGOW_HASKELL__ >= 904
sigBody = sig_body . unLoc
sigType = hsTypeToHsSigType
#else
sigBody = hsib_body
sigType = mkHsImplicitBndrs
#endif

typeVariable :: SrcSpan -> RdrName -> LHsType GhcPs
parenType :: SrcSpan -> LHsType GhcPs -> LHsType GhcPs
#if __GLASGOW_HASKELL__ >= 904
typeVariable at n = At at (HsTyVar noAnn NotPromoted (At at n))
parenType at t = At at (HsParTy noAnn t)
#else
typeVariable at n = At at (HsTyVar noExtField NotPromoted (At at n))
parenType at t = At at (HsParTy noExtField t)
#endif

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

-- * The typed tree

-- | A group of bindings with the polymorphic and monomorphic versions of its names.
pattern Abstraction :: [(Id, Id)] -> [LHsBind GhcTc] -> HsBind GhcTc
#if __GLASGOW_HASKELL__ >= 904
pattern Abstraction exports binds <- XHsBindsLR (AbsBinds {abs_exports = map exported -> exports, abs_binds = bagToList -> binds})

exported :: ABExport -> (Id, Id)
#else
pattern Abstraction exports binds <- AbsBinds {abs_exports = map exported -> exports, abs_binds = bagToList -> binds}

exported :: ABExport GhcTc -> (Id, Id)
#endif
exported e = (abe_mono e, abe_poly e)

-- | A data constructor as an expression.
pattern ConstructorExpression :: DataCon -> HsExpr GhcTc
#if __GLASGOW_HASKELL__ >= 904
pattern ConstructorExpression c <- XExpr (ConLikeTc (RealDataCon c) _ _)
#else
pattern ConstructorExpression c <- HsConLikeOut _ (RealDataCon c)
#endif

-- | A record field as a function.
pattern FieldSelector :: Id -> HsExpr GhcTc
#if __GLASGOW_HASKELL__ >= 904
pattern FieldSelector v <- HsRecSel _ (FieldOcc v _)
#else
pattern FieldSelector v <- HsRecFld _ (selected -> v)

selected :: AmbiguousFieldOcc GhcTc -> Id
selected f = case f of
  Unambiguous v _ -> v
  Ambiguous v _ -> v
#endif

-- | What the compiler has expanded an expression to.
pattern Expansion :: HsExpr GhcTc -> HsExpr GhcTc
#if __GLASGOW_HASKELL__ >= 910
pattern Expansion e <- XExpr (ExpandedThingTc _ e)
#else
pattern Expansion e <- XExpr (ExpansionExpr (HsExpanded _ e))
#endif

-- | The type of a list that is written out.
listType :: HsExpr GhcTc -> Maybe Type

-- | The constructor of a record construction, as an expression.
recordConstructor :: HsExpr GhcTc -> Maybe (HsExpr GhcTc)
#if __GLASGOW_HASKELL__ >= 904
listType e = case e of
  ExplicitList t _ -> Just (mkListTy t)
  _ -> Nothing
recordConstructor e = case e of
  RecordCon {rcon_ext = x} -> Just x
  _ -> Nothing
#else
listType e = case e of
  ExplicitList t _ _ -> Just (mkListTy t)
  _ -> Nothing
recordConstructor e = case e of
  RecordCon {rcon_ext = x} -> Just (rcon_con_expr x)
  _ -> Nothing
#endif

-- | A number of type 'Int'.
intLiteral :: Int -> LHsExpr GhcTc
intLiteral = nlHsLit . HsInt noExtField . mkIntegralLit
