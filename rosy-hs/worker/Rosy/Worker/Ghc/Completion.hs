{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE RankNTypes #-}
{-# LANGUAGE ScopedTypeVariables #-}

-- |
-- Module      : Rosy.Worker.Ghc.Completion
-- Description : Code completion: the names in scope whose types fit at a position.
--
-- Type-checks the program with a hole at the cursor. A hole-fit plugin receives the hole's type and everything in scope; GHC's own search,
-- which tries each name in turn, is too slow for interactive use.
module Rosy.Worker.Ghc.Completion
  ( complete,
  )
where

import Control.Monad.IO.Class (liftIO)
import Data.Data (Data, cast, gmapQ)
import Data.IORef (IORef, newIORef, readIORef, writeIORef)
import Data.List (sortOn)
import Data.Maybe (catMaybes, isJust, listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import GHC.Core.ConLike (ConLike (..))
import GHC.Core.DataCon (dataConName, dataConWrapId)
import GHC.Core.InstEnv (InstEnvs)
import GHC.Core.Predicate (getClassPredTys_maybe)
import GHC.Core.TyCon (isClassTyCon, tyConDataCons, tyConKind)
import GHC.Core.Type
import GHC.Data.StringBuffer (stringToStringBuffer)
import GHC.Driver.Plugins (Plugin)
import GHC.Driver.Session (GeneralFlag (Opt_ShowValidHoleFits), gopt_set)
import GHC.Hs hiding (Warning)
import GHC.Tc.Types
import GHC.Tc.Types.Constraint (Hole (..))
import GHC.Tc.Utils.Env (tcLookup)
import GHC.Tc.Utils.Instantiate (tcGetInstEnvs)
import GHC.Tc.Utils.TcType (isMetaTyVar, tcSplitSigmaTy)
import GHC.Types.Id (Id, idType)
import GHC.Types.Name (getOccString, nameOccName)
import GHC.Types.Name.Occurrence (isTcOcc, isValOcc, occNameString)
import GHC.Types.Name.Reader
import GHC.Types.SrcLoc (GenLocated (L), unLoc)
import GHC.Types.Var (isTcTyVar)
import GHC.Types.Var.Set (elemVarSet, mkVarSet)
import GHC.Unit.Module (moduleNameString)
import Rosy.Worker.CompletionHole (holeName, insertHole)
import Rosy.Worker.Ghc.Compat.Declarations
import Rosy.Worker.Ghc.Compat.Driver
import Rosy.Worker.Ghc.Compat.Syntax
import Rosy.Worker.Ghc.Compat.Types
import Rosy.Worker.Ghc.Declarations (showType)
import Rosy.Worker.Ghc.DeclaredTypes (InstanceBodies (..), generatedQualifier)
import Rosy.Worker.Ghc.Diagnostics (spanAt)
import Rosy.Worker.Ghc.Parsing
import Rosy.Worker.Ghc.Session (Session (..))
import Rosy.Worker.Ghc.SpanTypes (typedSpans)
import Rosy.Worker.Ghc.TreeRewrite (Rewritten (..), controllerFunctions, implicitNamesWith, rewriteProgram)
import Rosy.Worker.Problem (Candidate (..), Completion (..), Position, Span (..))
import Rosy.Worker.Refusals (refuseName)
import Rosy.Worker.TabStops (tabStopsOf)

-- | Completions for a value, a pattern or a type at a position.
complete :: Session -> Text -> Position -> IO Completion
complete session written at = case insertHole at written of
  Nothing -> pure nothing
  Just (source, spot) -> do
    let columns = tabStopsOf source
        buffer = stringToStringBuffer (Text.unpack source)
        plain = hsc_dflags (environment session)
    options <- programOptions Restricted plain columns source buffer
    case options of
      Right flags
        | Right (L place parsed, _) <- readProgram flags columns buffer,
          null (treeRefusals columns source parsed) -> do
          found <- newIORef Nothing
          let env = silenced (addPlugins [askingAboutHole found] (withFlags (gopt_set flags Opt_ShowValidHoleFits) (environment session)))
          (_, outcome) <- typecheck env (summaryOf env source) (L place (undecided (program (rewriteProgram EmptyBodies (onLinesContaining (map Text.pack controllerFunctions) source) (implicitNamesWith flags (implicitNames session)) parsed))))
          hole <- readIORef found
          let named = map (\(c, t) -> c {offersType = showType flags t})
              kinds = map (\(c, k) -> c {offersType = Text.replace "*" "Type" (showType flags k)})
          case (hole, outcome) of
            (Just (Wanted t fits), _) -> pure (Completion (showType flags <$> t) (named fits))
            (Nothing, Just checked)
              | isInType parsed -> Completion Nothing . kinds <$> typesInScope env checked
              | t : _ <- [t | (s, t) <- typedSpans checked, fmap start (spanAt columns s) == Just spot] -> pure (Completion (Just (showType flags t)) (named (constructorsOf t)))
            _ -> pure nothing
      _ -> pure nothing
  where
    nothing = Completion Nothing []

-- | Disables defaulting: otherwise the 3 in @_ 3@ would become an Integer.
undecided :: SyntaxTree -> SyntaxTree
undecided tree = tree {hsmodDecls = emptyDefault : filter (not . isDefault . unLoc) (hsmodDecls tree)}
  where
    isDefault :: HsDecl GhcPs -> Bool
    isDefault d = case d of
      DefD {} -> True
      _ -> False

-- | Whether the hole is parsed as a type variable.
isInType :: Data a => a -> Bool
isInType x = case cast x of
  Just (HsTyVar _ _ (L _ v) :: HsType GhcPs) -> Text.pack (occNameString (rdrNameOcc v)) == holeName
  _ -> or (gmapQ isInType x)

-- | The expected type at the hole, unless it is unconstrained, and the candidates, best first.
data Wanted = Wanted (Maybe Type) [(Candidate, Type)]

-- | Records what fits the hole.
askingAboutHole :: IORef (Maybe Wanted) -> Plugin
askingAboutHole found = holePlugin $ \typed inScope -> case th_hole typed of
  Just h | Text.pack (occNameString (holeNameOf h)) == holeName -> do
    wanted <- zonked (hole_ty h)
    known <- catMaybes <$> mapM looked inScope
    instances <- tcGetInstEnvs
    -- An inferred type variable may be any type; one from a signature may not.
    let inferred = mkVarSet (inferredVariables (th_implics typed))
        isFree v = v `elemVarSet` inferred || isTcTyVar v && isMetaTyVar v
        anything = maybe False isFree (getTyVar_maybe wanted)
    liftIO (writeIORef found (Just (Wanted (if anything then Nothing else Just wanted) (fitting instances isFree wanted known))))
  _ -> pure ()

-- | Origin of a name, in order of preference.
data Origin = Local | Own | Library | Haskell
  deriving (Eq, Ord)

data Known = Known Origin Text Type

looked :: HoleFitCandidate -> TcM (Maybe Known)
looked found = case found of
  IdHFCand v -> Just . Known Local (Text.pack (getOccString v)) <$> zonked (idType v)
  NameHFCand _ -> pure Nothing
  GreHFCand gre
    | isValOcc (nameOccName (elementName gre)),
      Just (origin, written) <- spelling gre -> do
      thing <- tcLookup (elementName gre)
      case thing of
        AGlobal (AnId v) -> known origin written v
        AGlobal (AConLike (RealDataCon c)) -> known origin written (dataConWrapId c)
        ATcId {tct_id = v} -> known origin written v
        _ -> pure Nothing
    | otherwise -> pure Nothing
  where
    known :: Origin -> Text -> Id -> TcM (Maybe Known)
    known origin written v = Just . Known origin written <$> zonked (idType v)

-- | Spelling of a name in the program. Excludes operators, refused names and generated names.
spelling :: GlobalRdrElt -> Maybe (Origin, Text)
spelling gre
  | not (all isWord word) || take 1 word == "_" || isJust (refuseName (Text.pack word)) = Nothing
  | gre_lcl gre = Just (Own, Text.pack word)
  | d : _ <- [d | d <- decls, not (is_qual d)] = Just (from d, Text.pack word)
  | d : _ <- decls, qualifier <- moduleNameString (is_as d), qualifier /= generatedQualifier = Just (from d, Text.pack (qualifier ++ "." ++ word))
  | otherwise = Nothing
  where
    word = occNameString (nameOccName (elementName gre))
    decls = map is_decl (elementImports gre)
    from d = if take 4 (importedModuleName d) == "Rosy" then Library else Haskell
    isWord c = c `elem` ['a' .. 'z'] || c `elem` ['A' .. 'Z'] || c `elem` ['0' .. '9'] || c `elem` ("_'" :: String)

-- | Candidates in order of preference: without arguments before with arguments, fully polymorphic results last.
fitting :: InstEnvs -> (TyVar -> Bool) -> Type -> [Known] -> [(Candidate, Type)]
fitting instances isFree wanted known = [(Candidate n "" k, t) | (_, n, k, t) <- take maxCandidates (sortOn (\(rank, n, _, _) -> (rank, n)) fits)]
  where
    fits = [((general, k > 0, origin, k), n, k, t) | Known origin n t <- known, Just (k, general) <- [fit t]]
    fit t = listToMaybe [(k, general) | (k, result) <- zip [0 ..] (results rho), Just general <- [matches vars theta result]]
      where
        (vars, theta, rho) = tcSplitSigmaTy t
    matches vars theta result = do
      substitute <- unifyWith bindable result wanted
      let general = maybe False (`elem` vars) (getTyVar_maybe (fst (splitAppTys result)))
      if all (holds . substitute) theta then Just general else Nothing
      where
        own = mkVarSet vars
        bindable v = v `elemVarSet` own || isFree v
    holds p = case getClassPredTys_maybe p of
      Just (c, ts) -> all isOpen ts || mayHaveInstance instances c ts
      Nothing -> True
    isOpen = isJust . getTyVar_maybe

-- | A type, and its results after each argument.
results :: Type -> [Type]
results t = t : maybe [] (\(_, _, r) -> results r) (functionParts t)

-- | Maximal number of candidates.
maxCandidates :: Int
maxCandidates = 300

-- | The constructors of a type.
constructorsOf :: Type -> [(Candidate, Type)]
constructorsOf t = case splitTyConApp_maybe t of
  Just (c, _) -> [(Candidate n "" (length (drop 1 (results rho))), idType w) | d <- tyConDataCons c, let w = dataConWrapId d, let n = Text.pack (getOccString (dataConName d)), Text.all (`notElem` ("()[],:#" :: String)) n, let (_, _, rho) = tcSplitSigmaTy (idType w)]
  Nothing -> []

-- | The types in scope with their kinds and arities.
typesInScope :: HscEnv -> TcGblEnv -> IO [(Candidate, Type)]
typesInScope env checked = do
  known <- concat <$> mapM kind (globalRdrEnvElts (tcg_rdr_env checked))
  pure [(Candidate n "" (length (drop 1 (results k))), k) | (_, n, k) <- sortOn (\(o, n, _) -> (o, n)) known]
  where
    kind gre = case spelling gre of
      Just (origin, n) | isTcOcc (nameOccName (elementName gre)) -> do
        thing <- maybe (lookupGlobal env (elementName gre)) (pure . Just) (lookupTypeEnv (tcg_type_env checked) (elementName gre))
        pure [(origin, n, tyConKind c) | Just (ATyCon c) <- [thing], not (isClassTyCon c)]
      _ -> pure []
