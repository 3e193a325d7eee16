{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE RankNTypes #-}
{-# LANGUAGE ScopedTypeVariables #-}

-- |
-- Module      : Rosy.Worker.Ghc.Complete
-- Description : What can stand at a place of a program: the names in scope whose types fit.
--
-- The compiler is asked about a hole at that place. While it writes its report of the hole it lets us look at everything in scope and at the
-- type that is wanted; what it would do itself, trying each name in turn, takes too long for somebody who types.
module Rosy.Worker.Ghc.Complete
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
import GHC.Core.Class (Class)
import GHC.Core.ConLike (ConLike (..))
import GHC.Core.DataCon (dataConName, dataConWrapId)
import GHC.Core.InstEnv (InstEnvs, lookupInstEnv)
import GHC.Core.Predicate (getClassPredTys_maybe)
import GHC.Core.TyCon (isClassTyCon, tyConDataCons, tyConKind)
import GHC.Core.Type
import GHC.Core.Unify (BindFlag (..), tcUnifyTys)
import GHC.Data.StringBuffer (stringToStringBuffer)
import GHC.Driver.Plugins (Plugin (..), PluginWithArgs (..), StaticPlugin (..), defaultPlugin)
import GHC.Driver.Session (DynFlags (..), GeneralFlag (Opt_ShowValidHoleFits), gopt_set)
import GHC.Driver.Types (HscEnv (..), lookupTypeEnv, lookupTypeHscEnv)
import GHC.Hs hiding (Warning)
import GHC.Tc.Errors.Hole.FitTypes
import GHC.Tc.Module (tcRnModule)
import GHC.Tc.Types
import GHC.Tc.Types.Constraint (Hole (..), Implication (..))
import GHC.Tc.Types.Origin (SkolemInfo (..))
import GHC.Tc.Utils.Env (tcLookup)
import GHC.Tc.Utils.Instantiate (tcGetInstEnvs)
import GHC.Tc.Utils.Monad (newTcRef)
import GHC.Tc.Utils.TcMType (zonkTcType)
import GHC.Tc.Utils.TcType (isMetaTyVar, tcSplitSigmaTy)
import GHC.Types.Id (Id, idType)
import GHC.Types.Name (getOccString, nameOccName)
import GHC.Types.Name.Occurrence (isTcOcc, isValOcc, occNameString)
import GHC.Types.Name.Reader
import GHC.Types.SrcLoc (GenLocated (L), noLoc, unLoc)
import GHC.Types.Var (isTcTyVar)
import GHC.Types.Var.Set (elemVarSet, mkVarSet)
import GHC.Unit.Module (moduleNameString)
import Rosy.Worker.Allow (refuseName)
import Rosy.Worker.Cursor (holeName, withHole)
import Rosy.Worker.Ghc.Add (Added (..), Instances (..), addRosy, broughtWith, generatedQualifier, namingWords)
import Rosy.Worker.Ghc.Describe (showType)
import Rosy.Worker.Ghc.Read
import Rosy.Worker.Ghc.Report (placeOf)
import Rosy.Worker.Ghc.Types (piecesOf)
import Rosy.Worker.Ghc.Warm (Session (..))
import Rosy.Worker.Place (columnsOf)
import Rosy.Worker.Problem (Candidate (..), Completion (..), Place, Span (..))

-- | What can stand at a place: as a value, in a pattern or in a type.
complete :: Session -> Text -> Place -> IO Completion
complete session written at = case withHole at written of
  Nothing -> pure nothing
  Just (source, spot) -> do
    let columns = columnsOf source
        buffer = stringToStringBuffer (Text.unpack source)
        plain = (hsc_dflags (environment session)) {log_action = \_ _ _ _ _ -> pure ()}
    options <- optionsOf Guarded plain columns source buffer
    case options of
      Right flags
        | Right (L place parsed, _) <- readProgram flags columns buffer,
          null (refusalsIn columns source parsed) -> do
          found <- newIORef Nothing
          let env = (environment session) {hsc_dflags = askingAboutHole found flags}
              summary = summaryOf (hsc_dflags env) source
          (_, outcome) <- tcRnModule env summary False (parsedModule (L place (undecided (program (addRosy Promised (linesWith (map Text.pack namingWords) source) (broughtWith flags (brought session)) parsed)))))
          hole <- readIORef found
          let named = map (\(c, t) -> c {offersType = showType flags t})
              kinds = map (\(c, k) -> c {offersType = Text.replace "*" "Type" (showType flags k)})
          case (hole, outcome) of
            (Just (Wanted t fits), _) -> pure (Completion (showType flags <$> t) (named fits))
            (Nothing, Just checked)
              | isInType parsed -> Completion Nothing . kinds <$> typesInScope env checked
              | t : _ <- [t | (s, t) <- piecesOf checked, fmap start (placeOf columns s) == Just spot] -> pure (Completion (Just (showType flags t)) (named (constructorsOf t)))
            _ -> pure nothing
      _ -> pure nothing
  where
    nothing = Completion Nothing []

-- | Without it the 3 in @_ 3@ would be an Integer before anybody has said what takes it.
undecided :: HsModule -> HsModule
undecided tree = tree {hsmodDecls = noLoc (DefD noExtField (DefaultDecl noExtField [])) : filter (not . isDefault . unLoc) (hsmodDecls tree)}
  where
    isDefault :: HsDecl GhcPs -> Bool
    isDefault d = case d of
      DefD {} -> True
      _ -> False

-- | Whether the hole is taken for a type's variable.
isInType :: Data a => a -> Bool
isInType x = case cast x of
  Just (HsTyVar _ _ (L _ v) :: HsType GhcPs) -> Text.pack (occNameString (rdrNameOcc v)) == holeName
  _ -> or (gmapQ isInType x)

-- | The type that is wanted at the hole, unless anything would do, and what fits, best first.
data Wanted = Wanted (Maybe Type) [(Candidate, Type)]

-- | Flags with which the compiler writes down what fits the hole.
askingAboutHole :: IORef (Maybe Wanted) -> DynFlags -> DynFlags
askingAboutHole found flags = gopt_set flags {staticPlugins = [StaticPlugin (PluginWithArgs plugin [])]} Opt_ShowValidHoleFits
  where
    plugin = defaultPlugin {holeFitPlugin = const (Just (HoleFitPluginR (newTcRef ()) (const (HoleFitPlugin look (\_ fits -> pure fits))) (const (pure ()))))}
    look typed inScope = do
      case th_hole typed of
        Just h | Text.pack (occNameString (hole_occ h)) == holeName -> do
          wanted <- zonkTcType (hole_ty h)
          known <- catMaybes <$> mapM looked inScope
          instances <- tcGetInstEnvs
          -- A variable that the compiler has made up may be any type; one that the learner has written may not.
          let inferred = mkVarSet [v | i <- th_implics typed, InferSkol {} <- [ic_info i], v <- ic_skols i]
              isFree v = v `elemVarSet` inferred || isTcTyVar v && isMetaTyVar v
              anything = maybe False isFree (getTyVar_maybe wanted)
          liftIO (writeIORef found (Just (Wanted (if anything then Nothing else Just wanted) (fitting instances isFree wanted known))))
        _ -> pure ()
      pure []

-- | How near a name is to the learner; the nearer first.
data Origin = Local | Own | Library | Haskell
  deriving (Eq, Ord)

data Known = Known Origin Text Type

looked :: HoleFitCandidate -> TcM (Maybe Known)
looked found = case found of
  IdHFCand v -> Just . Known Local (Text.pack (getOccString v)) <$> zonkTcType (idType v)
  NameHFCand _ -> pure Nothing
  GreHFCand gre
    | isValOcc (nameOccName (gre_name gre)),
      Just (origin, written) <- spelling gre -> do
      thing <- tcLookup (gre_name gre)
      case thing of
        AGlobal (AnId v) -> known origin written v
        AGlobal (AConLike (RealDataCon c)) -> known origin written (dataConWrapId c)
        ATcId {tct_id = v} -> known origin written v
        _ -> pure Nothing
    | otherwise -> pure Nothing
  where
    known :: Origin -> Text -> Id -> TcM (Maybe Known)
    known origin written v = Just . Known origin written <$> zonkTcType (idType v)

-- | How a program writes a name, if it may and can: words only, and nothing that Rosy has added.
spelling :: GlobalRdrElt -> Maybe (Origin, Text)
spelling gre
  | not (all isWord word) || take 1 word == "_" || isJust (refuseName (Text.pack word)) = Nothing
  | gre_lcl gre = Just (Own, Text.pack word)
  | d : _ <- [d | d <- decls, not (is_qual d)] = Just (from d, Text.pack word)
  | d : _ <- decls, qualifier <- moduleNameString (is_as d), qualifier /= generatedQualifier = Just (from d, Text.pack (qualifier ++ "." ++ word))
  | otherwise = Nothing
  where
    word = occNameString (nameOccName (gre_name gre))
    decls = map is_decl (gre_imp gre)
    from d = if take 4 (moduleNameString (is_mod d)) == "Rosy" then Library else Haskell
    isWord c = c `elem` ['a' .. 'z'] || c `elem` ['A' .. 'Z'] || c `elem` ['0' .. '9'] || c `elem` ("_'" :: String)

-- | What fits, the nearest first: what fits as it stands before what fits with values after it, and what gives anything last.
fitting :: InstEnvs -> (TyVar -> Bool) -> Type -> [Known] -> [(Candidate, Type)]
fitting instances isFree wanted known = [(Candidate n "" k, t) | (_, n, k, t) <- take mostCandidates (sortOn (\(rank, n, _, _) -> (rank, n)) fits)]
  where
    fits = [((general, k > 0, origin, k), n, k, t) | Known origin n t <- known, Just (k, general) <- [fit t]]
    fit t = listToMaybe [(k, general) | (k, result) <- zip [0 ..] (results rho), Just general <- [matches vars theta result]]
      where
        (vars, theta, rho) = tcSplitSigmaTy t
    matches vars theta result = do
      subst <- tcUnifyTys bindable [result] [wanted]
      let general = maybe False (`elem` vars) (getTyVar_maybe (fst (splitAppTys result)))
      if all (holds . substTy subst) theta then Just general else Nothing
      where
        own = mkVarSet vars
        bindable v = if v `elemVarSet` own || isFree v then BindMe else Skolem
    holds p = case getClassPredTys_maybe p of
      Just (c, ts) -> all isOpen ts || hasInstance c ts
      Nothing -> True
    isOpen = isJust . getTyVar_maybe
    hasInstance :: Class -> [Type] -> Bool
    hasInstance c ts = case lookupInstEnv False instances c ts of
      (found, possible, _) -> not (null found && null possible)

-- | A type, and what is left of it after each value it takes.
results :: Type -> [Type]
results t = t : maybe [] (\(_, _, r) -> results r) (splitFunTy_maybe t)

-- | More than anybody reads.
mostCandidates :: Int
mostCandidates = 300

-- | The patterns of a type.
constructorsOf :: Type -> [(Candidate, Type)]
constructorsOf t = case splitTyConApp_maybe t of
  Just (c, _) -> [(Candidate n "" (length (drop 1 (results rho))), idType w) | d <- tyConDataCons c, let w = dataConWrapId d, let n = Text.pack (getOccString (dataConName d)), Text.all (`notElem` ("()[],:#" :: String)) n, let (_, _, rho) = tcSplitSigmaTy (idType w)]
  Nothing -> []

-- | The types in scope with their kinds, and how many types each takes.
typesInScope :: HscEnv -> TcGblEnv -> IO [(Candidate, Type)]
typesInScope env checked = do
  known <- concat <$> mapM kind (globalRdrEnvElts (tcg_rdr_env checked))
  pure [(Candidate n "" (length (drop 1 (results k))), k) | (_, n, k) <- sortOn (\(o, n, _) -> (o, n)) known]
  where
    kind gre = case spelling gre of
      Just (origin, n) | isTcOcc (nameOccName (gre_name gre)) -> do
        thing <- maybe (lookupTypeHscEnv env (gre_name gre)) (pure . Just) (lookupTypeEnv (tcg_type_env checked) (gre_name gre))
        pure [(origin, n, tyConKind c) | Just (ATyCon c) <- [thing], not (isClassTyCon c)]
      _ -> pure []
