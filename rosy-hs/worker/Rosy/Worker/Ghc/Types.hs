{-# LANGUAGE GADTs #-}
{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE RankNTypes #-}
{-# LANGUAGE ScopedTypeVariables #-}
{-# LANGUAGE TypeOperators #-}

-- |
-- Module      : Rosy.Worker.Ghc.Types
-- Description : The type of every piece of a checked program, by its place.
--
-- Walks the typed tree and reads the type of each name, literal and expression off it, without compiling any further. What
-- the compiler or Rosy added has no place of its own and is passed over. The result is small: each type is written once.
module Rosy.Worker.Ghc.Types
  ( typesAt,
    piecesOf,
    standsIn,
  )
where

import Data.Data (Data, gmapQ)
import qualified Data.IntMap.Strict as IntMap
import Data.List (sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (isJust, mapMaybe)
import Data.Ord (Down (..))
import Data.Text (Text)
import Data.Typeable (eqT, (:~:) (..))
import GHC.Builtin.Types (mkListTy, mkTupleTy)
import GHC.Core.Coercion (coercionRKind)
import GHC.Core.ConLike (ConLike (..))
import GHC.Core.DataCon (DataCon, dataConWrapId)
import GHC.Core.TyCo.Rep (Scaled (..), TyLit (..), Type (..))
import GHC.Core.Type
import GHC.Data.Bag (bagToList)
import GHC.Data.FastString (uniqueOfFS)
import GHC.Hs
import GHC.Tc.Types (TcGblEnv (..))
import GHC.Tc.Types.Evidence
import GHC.Tc.Utils.Zonk (hsLitType)
import GHC.Types.Basic (Boxity (Boxed))
import GHC.Types.Id (Id, idType)
import GHC.Types.SrcLoc
import GHC.Types.Unique (Uniquable (..), getKey)
import Rosy.Worker.Problem (Span (..), Typed (..))

-- | In the order of the text, an outer piece before those inside it. The declarations whose places are given are passed over: what
-- the compiler derives from them stands there.
typesAt :: (Type -> Text) -> (SrcSpan -> Maybe Span) -> [SrcSpan] -> TcGblEnv -> [Typed]
typesAt shown place derived checked = named Map.empty . sortOn (\(s, _) -> (start s, Down (end s))) $ mapMaybe placed (take mostPieces (filter isOwn (piecesOf checked)))
  where
    isOwn = not . standsIn derived . fst
    placed (at, t) = place at >>= \s -> Just (s, t)
    named _ [] = []
    named known ((s, t) : rest) = case Map.lookup (keyOf t) known of
      Just text -> Typed s text : named known rest
      Nothing -> let text = shown t in Typed s text : named (Map.insert (keyOf t) text known) rest

-- | More than a page can show of a program at once; a program of a hundred lines has some 800.
mostPieces :: Int
mostPieces = 20000

-- * The walk

type Piece = (SrcSpan, Type)

-- | Whether a place is in the lines of one of these declarations.
standsIn :: [SrcSpan] -> SrcSpan -> Bool
standsIn declarations = \case
  RealSrcSpan s _ | Just (_, end') <- IntMap.lookupLE (srcSpanStartLine s) places -> srcSpanStartLine s <= end'
  _ -> False
  where
    places = IntMap.fromList [(srcSpanStartLine s, srcSpanEndLine s) | RealSrcSpan s _ <- declarations]

-- | Every piece, whoever wrote it, in no order.
piecesOf :: TcGblEnv -> [Piece]
piecesOf = bindings . tcg_binds

-- The walk names the shapes that programs are made of: asking each part of the tree what it is takes three times as long as the
-- type checker. What is rare is found by asking.

bindings :: LHsBinds GhcTc -> [Piece]
bindings = concatMap (binding Map.empty) . bagToList

-- | Inside, a function has the type of one use; its own is outside: the map knows it.
binding :: Map.Map Id Type -> LHsBind GhcTc -> [Piece]
binding outer (L _ b) = case b of
  AbsBinds {abs_exports = es, abs_binds = bs} -> concatMap (binding (Map.fromList [(abe_mono e, idType (abe_poly e)) | e <- es] `Map.union` outer)) (bagToList bs)
  FunBind {fun_id = L s f, fun_matches = m}
    | isWritten s -> concatMap (equation (Map.findWithDefault (idType f) f outer)) (unLoc (mg_alts m))
  PatBind {pat_lhs = p, pat_rhs = r} -> pattern' p ++ sides r
  _ -> []
  where
    equation :: Type -> LMatch GhcTc (LHsExpr GhcTc) -> [Piece]
    equation t l@(L whole m) = case m_ctxt m of
      FunRhs {mc_fun = L s _} -> concat [piece s t | s /= whole] ++ match l
      _ -> match l

matches :: MatchGroup GhcTc (LHsExpr GhcTc) -> [Piece]
matches m = concatMap match (unLoc (mg_alts m))

match :: LMatch GhcTc (LHsExpr GhcTc) -> [Piece]
match (L _ m) = concatMap pattern' (m_pats m) ++ sides (m_grhss m)

sides :: GRHSs GhcTc (LHsExpr GhcTc) -> [Piece]
sides r = concatMap side (grhssGRHSs r) ++ locals (grhssLocalBinds r)

side :: LGRHS GhcTc (LHsExpr GhcTc) -> [Piece]
side (L _ (GRHS _ guards e)) = concatMap statement guards ++ expression Nothing e

locals :: LHsLocalBinds GhcTc -> [Piece]
locals (L _ l) = case l of
  HsValBinds _ (XValBindsLR (NValBinds groups _)) -> concatMap (bindings . snd) groups
  _ -> []

statement :: ExprLStmt GhcTc -> [Piece]
statement (L _ s) = case s of
  LastStmt _ e _ _ -> expression Nothing e
  BindStmt _ p e -> pattern' p ++ expression Nothing e
  BodyStmt _ e _ _ -> expression Nothing e
  LetStmt _ l -> locals l
  _ -> rare Nothing s

-- | The place is that of the piece around it, whose type has been noted already.
expression :: Maybe SrcSpan -> LHsExpr GhcTc -> [Piece]
expression around (L at e) = here ++ inside e
  where
    here = case typeOfExpression e of
      Just t | isWritten at, Just at /= around -> [(at, t)]
      _ -> []
    -- What is added to the tree stands where it was added; only the outermost of it was written.
    below
      | isWritten at = Just at
      | otherwise = around
    inside :: HsExpr GhcTc -> [Piece]
    inside y = case y of
      HsVar {} -> []
      HsConLikeOut {} -> []
      HsLit {} -> []
      HsOverLit {} -> []
      -- Of f x y the piece f x says nothing that f does not say.
      HsApp _ f a -> function f ++ expression below a
      OpApp _ a o b -> expression below a ++ expression below o ++ expression below b
      HsPar _ x -> expression below x
      NegApp _ x _ -> expression below x
      SectionL _ a o -> expression below a ++ expression below o
      SectionR _ o b -> expression below o ++ expression below b
      HsLam _ m -> matches m
      HsLamCase _ m -> matches m
      HsCase _ x m -> expression below x ++ matches m
      HsIf _ c x z -> concatMap (expression below) [c, x, z]
      HsMultiIf _ gs -> concatMap side gs
      HsLet _ l x -> locals l ++ expression below x
      HsDo _ _ (L _ ss) -> concatMap statement ss
      ExplicitList _ _ xs -> concatMap (expression below) xs
      ExplicitTuple _ parts _ -> concat [expression below x | L _ (Present _ x) <- parts]
      ExprWithTySig _ z _ -> expression below z
      HsAppType _ z _ -> expression below z
      XExpr (WrapExpr (HsWrap _ z)) -> inside z
      XExpr (ExpansionExpr (HsExpanded _ z)) -> inside z
      _ -> rare below y
    function f@(L _ g) = case g of
      HsApp _ h a -> function h ++ expression below a
      XExpr (WrapExpr (HsWrap _ (HsApp _ h a))) -> function h ++ expression below a
      _ -> expression below f

pattern' :: LPat GhcTc -> [Piece]
pattern' (L at p) = case p of
  VarPat _ (L _ v) -> piece at (idType v)
  WildPat t -> piece at t
  LitPat _ l -> piece at (hsLitType l)
  NPat t _ _ _ -> piece at t
  ParPat _ x -> pattern' x
  BangPat _ x -> pattern' x
  LazyPat _ x -> pattern' x
  SigPat _ x _ -> pattern' x
  AsPat _ (L s v) x -> piece s (idType v) ++ pattern' x
  TuplePat _ xs _ -> concatMap pattern' xs
  ListPat _ xs -> concatMap pattern' xs
  ConPat {pat_con = L s (RealDataCon c), pat_con_ext = x, pat_args = args} -> piece s (constructorType c (cpt_arg_tys x)) ++ arguments args
  XPat (CoPat {co_pat_inner = x}) -> pattern' (L at x)
  _ -> rare Nothing p
  where
    arguments args = case args of
      PrefixCon xs -> concatMap pattern' xs
      InfixCon x y -> pattern' x ++ pattern' y
      RecCon fs -> concat [pattern' (hsRecFieldArg f) | L _ f <- rec_flds fs]

-- | The pieces in anything else.
rare :: forall a. Data a => Maybe SrcSpan -> a -> [Piece]
rare around = concat . gmapQ here
  where
    here :: forall b. Data b => b -> [Piece]
    here x
      | Just Refl <- eqT :: Maybe (b :~: LHsExpr GhcTc) = expression around x
      | Just Refl <- eqT :: Maybe (b :~: LPat GhcTc) = pattern' x
      | Just Refl <- eqT :: Maybe (b :~: LHsBind GhcTc) = binding Map.empty x
      | Just Refl <- eqT :: Maybe (b :~: HsWrapper) = []
      | Just Refl <- eqT :: Maybe (b :~: TcEvBinds) = []
      | Just Refl <- eqT :: Maybe (b :~: Type) = []
      | otherwise = rare around x

piece :: SrcSpan -> Type -> [Piece]
piece at t = [(at, t) | isWritten at]

isWritten :: SrcSpan -> Bool
isWritten = isGoodSrcSpan

-- * Types

-- | As far as the tree says it.
typeOfExpression :: HsExpr GhcTc -> Maybe Type
typeOfExpression e = case e of
  HsVar _ (L _ v) -> Just (idType v)
  HsConLikeOut _ (RealDataCon c) -> Just (constructorType c [])
  HsRecFld _ (Unambiguous v _) -> Just (idType v)
  HsRecFld _ (Ambiguous v _) -> Just (idType v)
  HsOverLit _ l -> Just (ol_type (ol_ext l))
  HsLit _ l -> Just (hsLitType l)
  HsLam _ m -> Just (functionType m)
  HsLamCase _ m -> Just (functionType m)
  HsApp _ f _ -> of' f >>= applied
  HsAppType _ f _ -> of' f
  OpApp _ _ f _ -> of' f >>= applied >>= applied
  NegApp _ x _ -> of' x
  HsPar _ x -> of' x
  SectionL _ _ f -> of' f >>= applied
  SectionR _ f _ -> of' f >>= rightSection
  ExplicitTuple _ parts Boxed -> mkTupleTy Boxed <$> mapM part parts
  HsCase _ _ m -> Just (mg_res_ty (mg_ext m))
  HsIf _ _ x _ -> of' x
  HsMultiIf t _ -> Just t
  HsLet _ _ x -> of' x
  HsDo t _ _ -> Just t
  ExplicitList t _ _ -> Just (mkListTy t)
  RecordCon {rcon_ext = x} -> result <$> typeOfExpression (rcon_con_expr x)
  ExprWithTySig _ x _ -> of' x
  ArithSeq x _ _ -> typeOfExpression x >>= Just . result
  XExpr (WrapExpr (HsWrap w (HsConLikeOut _ (RealDataCon c)))) -> Just (constructorType c (typesIn w))
  XExpr (WrapExpr (HsWrap w x)) -> typeOfExpression x >>= wrapped w
  XExpr (ExpansionExpr (HsExpanded _ x)) -> typeOfExpression x
  _ -> Nothing
  where
    of' (L _ x) = typeOfExpression x
    functionType m = mkVisFunTys (mg_arg_tys (mg_ext m)) (mg_res_ty (mg_ext m))
    part (L _ a) = case a of
      Present _ x -> of' x
      _ -> Nothing
    rightSection t = do
      (w, a, rest) <- splitFunTy_maybe t
      (_, _, r) <- splitFunTy_maybe rest
      Just (mkVisFunTys [Scaled w a] r)
    result t = maybe t (\(_, _, r) -> result r) (splitFunTy_maybe t)

applied :: Type -> Maybe Type
applied t = (\(_, _, r) -> r) <$> splitFunTy_maybe t

-- | A constructor at these types, which may be fewer than it has.
constructorType :: DataCon -> [Type] -> Type
constructorType c given = withoutConstraints (foldl at (idType (dataConWrapId c)) given)
  where
    at t x = if isJust (splitForAllTy_maybe t) then piResultTy t x else t
    withoutConstraints t = case t of
      FunTy InvisArg _ _ rest -> withoutConstraints rest
      _ -> t

-- | The types that a wrapper applies something to, first ones first.
typesIn :: HsWrapper -> [Type]
typesIn = foldl step [] . inside
  where
    inside w = case w of
      WpCompose a b -> inside b ++ inside a
      WpFun a b _ _ -> inside a ++ inside b
      _ -> [w]
    step found w = case w of
      -- What was applied further inside has become general again.
      WpTyLam _ -> []
      -- How often a constructor uses what it holds is none of a learner's business.
      WpTyApp t | not (isMultiplicityTy (typeKind t)) -> found ++ [t]
      _ -> found

-- | What the compiler has found out about a use of something more general.
wrapped :: HsWrapper -> Type -> Maybe Type
wrapped w t = case w of
  WpHole -> Just t
  WpCompose a b -> wrapped b t >>= wrapped a
  WpTyApp x | isJust (splitForAllTy_maybe t) -> Just (piResultTy t x)
  WpEvApp _ -> applied t
  WpLet _ -> Just t
  WpCast c -> Just (coercionRKind c)
  WpFun _ r a _ -> do
    (_, _, rest) <- splitFunTy_maybe t
    rest' <- wrapped r rest
    Just (mkVisFunTys [a] rest')
  WpMultCoercion _ -> Just t
  _ -> Nothing

-- | The same for types that are written the same. Synonyms are not looked through: a learner who wrote @Hit@ reads @Hit@.
keyOf :: Type -> [Int]
keyOf t = go t []
  where
    go :: Type -> [Int] -> [Int]
    go y rest = case y of
      TyVarTy v -> 1 : unique v : rest
      AppTy f a -> 2 : go f (go a rest)
      TyConApp c args -> 3 : unique c : length args : foldr go rest args
      ForAllTy b inner -> 4 : unique (binderVar b) : go inner rest
      FunTy _ _ a b -> 5 : go a (go b rest)
      LitTy (NumTyLit n) -> 6 : fromInteger n : rest
      LitTy (StrTyLit s) -> 8 : uniqueOfFS s : rest
      CastTy inner _ -> go inner rest
      CoercionTy _ -> 7 : rest
    unique :: Uniquable a => a -> Int
    unique = getKey . getUnique
