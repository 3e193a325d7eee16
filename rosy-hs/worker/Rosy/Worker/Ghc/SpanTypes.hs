{-# LANGUAGE GADTs #-}
{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE RankNTypes #-}
{-# LANGUAGE ScopedTypeVariables #-}
{-# LANGUAGE TypeOperators #-}

-- |
-- Module      : Rosy.Worker.Ghc.SpanTypes
-- Description : Types of all source spans of a checked program.
--
-- Walks the typed tree and reads the type of each name, literal and expression, without desugaring. Generated code has no spans of its own
-- and is skipped. Each distinct type is printed once.
module Rosy.Worker.Ghc.SpanTypes
  ( typesAt,
    typedSpans,
    typeOfExpression,
    isInside,
  )
where

import Data.Char (isAlpha)
import Data.Data (Data, gmapQ)
import qualified Data.IntMap.Strict as IntMap
import Data.List (sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (isJust, mapMaybe)
import Data.Ord (Down (..))
import Data.Text (Text)
import Data.Typeable (eqT, (:~:) (..))
import GHC.Builtin.Types (mkTupleTy)
import GHC.Core.Coercion (coercionRKind)
import GHC.Core.ConLike (ConLike (..))
import GHC.Core.DataCon (DataCon, dataConWrapId)
import GHC.Core.TyCo.Rep (Scaled (..), Type (..))
import GHC.Core.Type
import GHC.Hs
import GHC.Tc.Types (TcGblEnv (..))
import GHC.Tc.Types.Evidence
import GHC.Types.Basic (Boxity (Boxed))
import GHC.Types.Id (Id, idType)
import GHC.Types.Name (getOccString)
import GHC.Types.SrcLoc
import GHC.Types.Unique (Uniquable (..))
import Rosy.Worker.Ghc.Compat.Syntax
import Rosy.Worker.Ghc.Compat.TypedTree
import Rosy.Worker.Ghc.Compat.Types
import Rosy.Worker.Problem (Span (..), Typed (..))

-- | Those of 'typedSpans' in source order, outer spans before inner ones. The given declarations are skipped: derived code has their spans.
typesAt :: (Type -> Text) -> (SrcSpan -> Maybe Span) -> [SrcSpan] -> [(SrcSpan, Type)] -> [Typed]
typesAt shown place derived spans = named Map.empty . sortOn (\(s, _) -> (start s, Down (end s))) $ mapMaybe placed (take maxSpans (filter isOwn spans))
  where
    isOwn = not . isInside derived . fst
    placed (at, t) = place at >>= \s -> Just (s, t)
    named _ [] = []
    named known ((s, t) : rest) = case Map.lookup (keyOf t) known of
      Just text -> Typed s text : named known rest
      Nothing -> let text = shown t in Typed s text : named (Map.insert (keyOf t) text known) rest

-- | Maximal number of spans; a program of a hundred lines has about 800.
maxSpans :: Int
maxSpans = 20000

-- * The walk

type Piece = (SrcSpan, Type)

-- | Whether a span is within the lines of one of these declarations.
isInside :: [SrcSpan] -> SrcSpan -> Bool
isInside declarations = \case
  RealSrcSpan s _ | Just (_, end') <- IntMap.lookupLE (srcSpanStartLine s) places -> srcSpanStartLine s <= end'
  _ -> False
  where
    places = IntMap.fromList [(srcSpanStartLine s, srcSpanEndLine s) | RealSrcSpan s _ <- declarations]

-- | Every span with its type, generated code included, unordered.
typedSpans :: TcGblEnv -> [Piece]
typedSpans = bindings . tcg_binds

-- The walk matches common constructors explicitly: a generic traversal takes three times as long as the type checker. Rare
-- constructors are traversed generically.

bindings :: LHsBinds GhcTc -> [Piece]
bindings = concatMap (binding Map.empty) . bindList

-- | Inside, a function has a monomorphic type; the map has its polymorphic type.
binding :: Map.Map Id Type -> LHsBind GhcTc -> [Piece]
binding outer (L _ b) = case b of
  Abstraction es bs -> concatMap (binding (Map.fromList [(mono, idType poly) | (mono, poly) <- es] `Map.union` outer)) bs
  FunBind {fun_id = At s f, fun_matches = m}
    | isWritten s -> concatMap (equation (Map.findWithDefault (idType f) f outer)) (unLoc (mg_alts m))
  PatBind {pat_lhs = p, pat_rhs = r} -> pattern' p ++ sides r
  _ -> []
  where
    equation :: Type -> LMatch GhcTc (LHsExpr GhcTc) -> [Piece]
    equation t l@(At whole m) = case m_ctxt m of
      FunRhs {mc_fun = At s n} -> concat [piece at t | Just at <- [nameOfEquation whole s (getOccString n) (m_pats m)], at /= whole] ++ match l
      _ -> match l

-- | The place of the function's name in an equation, from the span of the equation, the place that the typed tree has for the name, the name,
-- and the patterns. Before GHC 9.10 the tree has the name's place in the first equation for all of them; in the others the name is what they start
-- with, unless it is an operator or stands between two patterns.
nameOfEquation :: SrcSpan -> SrcSpan -> String -> [LPat GhcTc] -> Maybe SrcSpan
nameOfEquation whole known name patterns
  | known `isSubspanOf` whole = Just known
  | isIdentifier, RealSrcSpan s _ <- whole, and [realSrcSpanStart p >= end s | RealSrcSpan p _ <- map spanOf (take 1 patterns)] = Just (mkSrcSpan (srcSpanStart whole) (realLocation (end s)))
  | otherwise = Nothing
  where
    isIdentifier = all (\c -> isAlpha c || c == '_') (take 1 name)
    end s = mkRealSrcLoc (srcSpanFile s) (srcSpanStartLine s) (srcSpanStartCol s + length name)
    realLocation l = mkSrcLoc (srcLocFile l) (srcLocLine l) (srcLocCol l)

matches :: MatchGroup GhcTc (LHsExpr GhcTc) -> [Piece]
matches m = concatMap match (unLoc (mg_alts m))

match :: LMatch GhcTc (LHsExpr GhcTc) -> [Piece]
match (L _ m) = concatMap pattern' (m_pats m) ++ sides (m_grhss m)

sides :: GRHSs GhcTc (LHsExpr GhcTc) -> [Piece]
sides r = concatMap side (grhssGRHSs r) ++ locals (localBindings r)

side :: LGRHS GhcTc (LHsExpr GhcTc) -> [Piece]
side (L _ (GRHS _ guards e)) = concatMap statement guards ++ expression Nothing e

locals :: HsLocalBinds GhcTc -> [Piece]
locals l = case l of
  HsValBinds _ (XValBindsLR (NValBinds groups _)) -> concatMap (bindings . snd) groups
  _ -> []

statement :: ExprLStmt GhcTc -> [Piece]
statement (L _ s) = case s of
  LastStmt _ e _ _ -> expression Nothing e
  BindStmt _ p e -> pattern' p ++ expression Nothing e
  BodyStmt _ e _ _ -> expression Nothing e
  LetStmt _ l -> locals (letStatement l)
  _ -> rare Nothing s

-- | The argument is the enclosing span, whose type has been recorded already.
expression :: Maybe SrcSpan -> LHsExpr GhcTc -> [Piece]
expression around (At at e) = here ++ inside e
  where
    here = case typeOfExpression e of
      Just t | isWritten at, Just at /= around -> [(at, t)]
      _ -> []
    -- Generated code has the span of the expression it was added to; only the outermost one was written.
    below
      | isWritten at = Just at
      | otherwise = around
    inside :: HsExpr GhcTc -> [Piece]
    inside y = case y of
      HsVar {} -> []
      ConstructorExpression _ -> []
      HsLit {} -> []
      HsOverLit {} -> []
      -- In f x y the type of f x adds nothing to that of f.
      HsApp _ f a -> function f ++ expression below a
      OpApp _ a o b -> expression below a ++ expression below o ++ expression below b
      Paren x -> expression below x
      NegApp _ x _ -> expression below x
      SectionL _ a o -> expression below a ++ expression below o
      SectionR _ o b -> expression below o ++ expression below b
      Lambda m -> matches m
      LambdaCase m -> matches m
      HsCase _ x m -> expression below x ++ matches m
      HsIf _ c x z -> concatMap (expression below) [c, x, z]
      HsMultiIf _ gs -> concatMap side gs
      LetIn l x -> locals l ++ expression below x
      HsDo _ _ (L _ ss) -> concatMap statement ss
      ListOf xs -> concatMap (expression below) xs
      ExplicitTuple _ parts _ -> concat [expression below x | Present _ x <- tupleParts parts]
      ExprWithTySig _ z _ -> expression below z
      TypeApplied z -> expression below z
      XExpr (WrapExpr (HsWrap _ z)) -> inside z
      Expansion z -> inside z
      _ -> rare below y
    function f@(L _ g) = case g of
      HsApp _ h a -> function h ++ expression below a
      XExpr (WrapExpr (HsWrap _ (HsApp _ h a))) -> function h ++ expression below a
      _ -> expression below f

pattern' :: LPat GhcTc -> [Piece]
pattern' (At at p) = case p of
  VarPat _ (L _ v) -> piece at (idType v)
  WildPat t -> piece at t
  LitPat _ l -> piece at (hsLitType l)
  NPat t _ _ _ -> piece at t
  ParenPattern x -> pattern' x
  BangPat _ x -> pattern' x
  LazyPat _ x -> pattern' x
  SigPat _ x _ -> pattern' x
  AsPattern (At s v) x -> piece s (idType v) ++ pattern' x
  TuplePat _ xs _ -> concatMap pattern' xs
  ListPat _ xs -> concatMap pattern' xs
  ConPat {pat_con = At s (RealDataCon c), pat_con_ext = x, pat_args = args} -> piece s (constructorType c (cpt_arg_tys x)) ++ arguments args
  XPat (CoPat {co_pat_inner = x}) -> pattern' (At at x)
  _ -> rare Nothing p
  where
    arguments args = case args of
      PrefixArguments xs -> concatMap pattern' xs
      InfixCon x y -> pattern' x ++ pattern' y
      RecCon fs -> concatMap pattern' (recordArguments fs)

-- | Generic traversal of everything else.
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

-- | The type of an expression, where the tree contains it.
typeOfExpression :: HsExpr GhcTc -> Maybe Type
typeOfExpression e = case e of
  HsVar _ (L _ v) -> Just (idType v)
  ConstructorExpression c -> Just (constructorType c [])
  FieldSelector v -> Just (idType v)
  HsOverLit _ l -> Just (ol_type (ol_ext l))
  HsLit _ l -> Just (hsLitType l)
  Lambda m -> Just (lambdaType m)
  LambdaCase m -> Just (lambdaType m)
  HsApp _ f _ -> of' f >>= applied
  TypeApplied f -> of' f
  OpApp _ _ f _ -> of' f >>= applied >>= applied
  NegApp _ x _ -> of' x
  Paren x -> of' x
  SectionL _ _ f -> of' f >>= applied
  SectionR _ f _ -> of' f >>= rightSection
  ExplicitTuple _ parts Boxed -> mkTupleTy Boxed <$> mapM part (tupleParts parts)
  HsCase _ _ m -> Just (mg_res_ty (mg_ext m))
  HsIf _ _ x _ -> of' x
  HsMultiIf t _ -> Just t
  LetIn _ x -> of' x
  HsDo t _ _ -> Just t
  ExplicitList {} -> listType e
  RecordCon {} -> result <$> (recordConstructor e >>= typeOfExpression)
  ExprWithTySig _ x _ -> of' x
  ArithSeq x _ _ -> typeOfExpression x >>= Just . result
  XExpr (WrapExpr (HsWrap w (ConstructorExpression c))) -> Just (constructorType c (typesIn w))
  XExpr (WrapExpr (HsWrap w x)) -> typeOfExpression x >>= wrapped w
  Expansion x -> typeOfExpression x
  _ -> Nothing
  where
    of' (L _ x) = typeOfExpression x
    lambdaType m = functionType (mg_arg_tys (mg_ext m)) (mg_res_ty (mg_ext m))
    part a = case a of
      Present _ x -> of' x
      _ -> Nothing
    rightSection t = do
      (w, a, rest) <- functionParts t
      (_, _, r) <- functionParts rest
      Just (functionType [Scaled w a] r)
    result t = maybe t (\(_, _, r) -> result r) (functionParts t)

applied :: Type -> Maybe Type
applied t = (\(_, _, r) -> r) <$> functionParts t

-- | The type of a constructor applied to some of its type arguments.
constructorType :: DataCon -> [Type] -> Type
constructorType c given = withoutConstraints (foldl at (idType (dataConWrapId c)) given)
  where
    at t x = if isJust (splitForAll t) then piResultTy t x else t
    withoutConstraints t = maybe t withoutConstraints (constraintResult t)

-- | The type arguments of a wrapper, in order.
typesIn :: HsWrapper -> [Type]
typesIn = foldl step [] . inside
  where
    inside w = case w of
      WpCompose a b -> inside b ++ inside a
      WrapFunction a b _ -> inside a ++ inside b
      _ -> [w]
    step found w = case w of
      -- Generalisation discards inner type arguments.
      WpTyLam _ -> []
      -- Multiplicities are not shown.
      WpTyApp t | not (isMultiplicityTy (typeKind t)) -> found ++ [t]
      _ -> found

-- | The type of an expression inside a wrapper.
wrapped :: HsWrapper -> Type -> Maybe Type
wrapped w t = case w of
  WpHole -> Just t
  WpCompose a b -> wrapped b t >>= wrapped a
  WpTyApp x | isJust (splitForAll t) -> Just (piResultTy t x)
  WpEvApp _ -> applied t
  WpLet _ -> Just t
  WpCast c -> Just (coercionRKind c)
  WrapFunction _ r a -> do
    (_, _, rest) <- functionParts t
    rest' <- wrapped r rest
    Just (functionType [a] rest')
  WpMultCoercion _ -> Just t
  _ -> Nothing

-- | Structural key of a type. Synonyms are not expanded: a type written as @Hit@ is shown as @Hit@.
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
      LitTy l -> literalKey l ++ rest
      CastTy inner _ -> go inner rest
      CoercionTy _ -> 7 : rest
    unique :: Uniquable a => a -> Int
    unique = uniqueNumber
