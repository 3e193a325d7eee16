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
-- Module      : Rosy.Worker.Ghc.Compat.TypedTree
-- Description : Compatibility layer over the tree that the type checker makes.
module Rosy.Worker.Ghc.Compat.TypedTree
  ( pattern Abstraction,
    pattern ConstructorExpression,
    pattern FieldSelector,
    pattern Expansion,
    hsLitType,
    listType,
    recordConstructor,
    intLiteral,
  )
where

import GHC.Builtin.Types (mkListTy)
import GHC.Core.ConLike (ConLike (..))
import GHC.Core.DataCon (DataCon)
import GHC.Core.TyCo.Rep (Type)
import GHC.Data.Bag (bagToList)
import GHC.Hs
import GHC.Types.Id (Id)
import GHC.Types.SrcLoc
#if __GLASGOW_HASKELL__ >= 904
import GHC.Hs.Syn.Type (hsLitType)
import GHC.Parser.Annotation
import GHC.Types.SourceText (mkIntegralLit)
#else
import GHC.Types.Basic (mkIntegralLit)
import GHC.Tc.Utils.Zonk (hsLitType)
#endif
import Rosy.Worker.Ghc.Compat.Syntax

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
