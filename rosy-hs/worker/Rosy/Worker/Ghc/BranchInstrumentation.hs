{-# LANGUAGE GADTs #-}
{-# LANGUAGE RankNTypes #-}
{-# LANGUAGE ScopedTypeVariables #-}
{-# LANGUAGE TypeOperators #-}

-- |
-- Module      : Rosy.Worker.Ghc.BranchInstrumentation
-- Description : Branch instrumentation of a checked program: each branch of a choice says when it is taken.
--
-- In the typed tree a right-hand side @e@ becomes @tick n `seq` e@ ("Rosy.BranchCoverage"), which the desugarer turns into a case: there is no
-- new thunk, so tail calls stay tail calls. The tree is changed after all messages were made, and patterns and guards stay as they are. Branches outside of all
-- functions are left alone: such a value is computed once for all firings.
module Rosy.Worker.Ghc.BranchInstrumentation
  ( instrumentBranches,
  )
where

import Control.Monad (zipWithM)
import Data.Data (Data, gmapM)
import Data.IORef
import Data.Text (Text)
import qualified Data.Text as Text
import Data.Typeable (eqT, (:~:) (..))
import GHC.Builtin.Types (unitTy)
import GHC.Core.Type (Type, getRuntimeRep)
import GHC.Hs
import GHC.Tc.Types (TcGblEnv (..))
import GHC.Tc.Types.Evidence
import GHC.Types.Id (Id, idType)
import GHC.Types.Id.Make (seqId)
import GHC.Types.Name
import GHC.Types.SrcLoc
import Rosy.Worker.Branch (Branch)
import Rosy.Worker.Ghc.Compat.Driver
import Rosy.Worker.Ghc.Compat.Syntax
import Rosy.Worker.Ghc.Compat.TypedTree
import Rosy.Worker.Ghc.Compat.Types
import Rosy.Worker.Ghc.SpanTypes (typeOfExpression)
import Rosy.Worker.Problem (Position (..), Span (..))

-- | The program with its branches, in the order of their numbers from 0. Only what the function gives a span was written by the learner.
instrumentBranches :: HscEnv -> (SrcSpan -> Maybe Span) -> Text -> TcGblEnv -> IO (TcGblEnv, [Branch])
instrumentBranches env place source checked = do
  marker <- libraryValue env "Rosy.BranchCoverage" "tick"
  case marker of
    Nothing -> pure (checked, [])
    Just ticker -> do
      branches <- newIORef []
      let context = Context {tick = ticker, placeOf = place, textOf = sliceOf source, found = branches, definitions = [], isInFunction = False}
      binds <- walk context (tcg_binds checked)
      (,) checked {tcg_binds = binds} . reverse <$> readIORef branches

data Context = Context
  { tick :: Id,
    placeOf :: SrcSpan -> Maybe Span,
    textOf :: Span -> String,
    -- | The branches so far, newest first.
    found :: IORef [Branch],
    -- | Names of the definitions around, innermost first.
    definitions :: [String],
    isInFunction :: Bool
  }

walk :: forall a. Data a => Context -> a -> IO a
walk c x
  | Just Refl <- eqT :: Maybe (a :~: HsBind GhcTc) = case x of
    FunBind {fun_id = At _ f} -> gmapM (walk c {definitions = nameOf f : definitions c}) x
    _ -> gmapM (walk c) x
  | Just Refl <- eqT :: Maybe (a :~: MatchGroup GhcTc (LHsExpr GhcTc)) = alternatives c {isInFunction = isInFunction c || takesArguments x} x
  | Just Refl <- eqT :: Maybe (a :~: HsExpr GhcTc) = expression c x
  -- Types and evidence have no branches.
  | Just Refl <- eqT :: Maybe (a :~: HsWrapper) = pure x
  | Just Refl <- eqT :: Maybe (a :~: TcEvBinds) = pure x
  | Just Refl <- eqT :: Maybe (a :~: Type) = pure x
  | otherwise = gmapM (walk c) x
  where
    -- The method of an instance has a generated name, as @$cshow@.
    nameOf f = case getOccString f of
      '$' : 'c' : method -> method
      name -> name
    takesArguments :: MatchGroup GhcTc (LHsExpr GhcTc) -> Bool
    takesArguments m = or [not (null (m_pats one)) | L _ one <- unLoc (mg_alts m)]

expression :: Context -> HsExpr GhcTc -> IO (HsExpr GhcTc)
expression c e = case e of
  HsCase x scrutinee m -> HsCase x <$> walk c scrutinee <*> alternatives c m
  HsIf x condition yes no
    | Just t <- typeOfExpression e,
      Just asked <- placeOf c (spanOf condition) -> do
      let side kind number part = walk c part >>= ticking c t kind number (textOf c asked) (placeOf c (spanOf part))
      HsIf x <$> walk c condition <*> side "then" 1 yes <*> side "else" 2 no
  HsMultiIf t sides -> HsMultiIf t <$> guardedSides c t sides
  _ -> gmapM (walk c) e

-- | The equations of a function, or the alternatives of a case.
alternatives :: Context -> MatchGroup GhcTc (LHsExpr GhcTc) -> IO (MatchGroup GhcTc (LHsExpr GhcTc))
alternatives c m = case mg_alts m of
  L at [one] -> do
    one' <- inMatch (guardedSides c result) one
    pure m {mg_alts = L at [one']}
  L at several -> do
    several' <- zipWithM alternative [1 ..] several
    pure m {mg_alts = L at several'}
  where
    result = mg_res_ty (mg_ext m)
    alternative number l@(At at one) = inMatch (mapM (inside (side number at one))) l
    side number at one (GRHS x guards e) = do
      guards' <- walk c guards
      e' <- walk c e
      let left = patternText c at one
          shownText = if null guards then left else left ++ " | " ++ guardText c guards
          place = if null guards then placeOf c at else sidePlace c guards e
      GRHS x guards' <$> ticking c result (kindOf one) number shownText place e'
    kindOf one = case m_ctxt one of
      FunRhs {} -> "equation"
      _ -> "case"
    -- Local definitions are walked as well.
    inMatch change (L at one) = do
      let sides = m_grhss one
      changed <- change (grhssGRHSs sides)
      rest <- gmapM (walk c) (sides {grhssGRHSs = []} `asTypeOf` sides)
      pure (L at one {m_grhss = rest {grhssGRHSs = changed}})

-- | The guards of one equation or alternative; where there is one side, nothing is chosen.
guardedSides :: Context -> Type -> [LGRHS GhcTc (LHsExpr GhcTc)] -> IO [LGRHS GhcTc (LHsExpr GhcTc)]
guardedSides c t sides = case sides of
  [_] -> mapM (walk c) sides
  _ -> zipWithM (inside . side) [1 ..] sides
  where
    side number (GRHS x guards e) = do
      guards' <- walk c guards
      e' <- walk c e
      GRHS x guards' <$> ticking c t "guard" number (guardText c guards) (sidePlace c guards e) e'

inside :: (e -> IO e) -> GenLocated l e -> IO (GenLocated l e)
inside change (L at x) = L at <$> change x

-- | From the first guard to the end of the right-hand side.
sidePlace :: Context -> [ExprLStmt GhcTc] -> LHsExpr GhcTc -> Maybe Span
sidePlace c guards e = case map spanOf guards of
  first : _ -> Span . start <$> placeOf c first <*> (end <$> placeOf c (spanOf e))
  [] -> placeOf c (spanOf e)

-- | The left side of an equation, or the pattern of an alternative.
patternText :: Context -> SrcSpan -> Match GhcTc (LHsExpr GhcTc) -> String
patternText c at one = maybe "" (textOf c) $ do
  begin <- start <$> placeOf c at
  finish <- case map spanOf (m_pats one) of
    [] -> Nothing
    places -> end <$> placeOf c (last places)
  pure (Span begin finish)

guardText :: Context -> [ExprLStmt GhcTc] -> String
guardText c guards = maybe "" (textOf c) $ case map spanOf guards of
  [] -> Nothing
  places -> Span . start <$> placeOf c (head places) <*> (end <$> placeOf c (last places))

-- | The expression, which says first that its branch is taken.
ticking :: Context -> Type -> String -> Int -> String -> Maybe Span -> LHsExpr GhcTc -> IO (LHsExpr GhcTc)
ticking c t kind number shownText place e = case place of
  Just (Span (Position l1 c1) (Position l2 c2))
    | isInFunction c,
      shownText /= "" -> do
      known <- readIORef (found c)
      writeIORef (found c) (((l1, c1), (l2, c2), reverse (definitions c), kind, number, shownText) : known)
      pure (nlHsApp (nlHsApp (nlHsTyApp seqId (runtimeReps ++ [unitTy, t])) (nlHsApp (nlHsVar (tick c)) (intLiteral (length known)))) e)
  _ -> pure e
  where
    -- Older compilers have no type argument for the representation.
    runtimeReps = [getRuntimeRep t | length (fst (splitForAlls (idType seqId))) > 2]

-- | The characters of a span on one line, cut to a length that fits a sentence.
sliceOf :: Text -> Span -> String
sliceOf source (Span (Position l1 c1) (Position l2 c2)) = shortened (Text.unwords (Text.words (Text.unlines part)))
  where
    part = case take (l2 - l1 + 1) (drop (l1 - 1) (Text.lines source)) of
      [one] -> [Text.take (c2 - c1) (Text.drop (c1 - 1) one)]
      first : rest@(_ : _) -> Text.drop (c1 - 1) first : init rest ++ [Text.take (c2 - 1) (last rest)]
      [] -> []
    shortened text = if Text.length text > longestText then Text.unpack (Text.take (longestText - 1) text) ++ "…" else Text.unpack text

-- | Characters of the text that shows a branch. A choice of ours.
longestText :: Int
longestText = 60
