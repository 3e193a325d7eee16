{-# LANGUAGE CPP #-}
{-# LANGUAGE FlexibleContexts #-}
{-# LANGUAGE FlexibleInstances #-}
{-# LANGUAGE PatternSynonyms #-}
{-# LANGUAGE ScopedTypeVariables #-}
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

    -- * Types
    sigBody,
    sigType,
    typeVariable,
    parenType,
  )
where

import GHC.Data.Bag (Bag, bagToList, listToBag)
import GHC.Hs
import GHC.Types.Name.Reader (RdrName)
import GHC.Types.SrcLoc
#if __GLASGOW_HASKELL__ >= 904
import GHC.Parser.Annotation
import GHC.Types.Basic (PromotionFlag (NotPromoted))
import GHC.Types.SourceText (IntegralLit (il_value))
#else
import GHC.Types.Basic (IntegralLit (il_value), PromotionFlag (NotPromoted))
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

-- * Types

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
