-- |
-- Module      : Rosy.Worker.Ghc.TaskAttribution
-- Description : Core pass that attributes every task to the definition that contains it.
--
-- The time a function takes is attributed to the function. Between two firings the program computes the next task, which may not terminate
-- either: @patrol = forever (pure ())@. Therefore every expression of type @Task a@ is wrapped in 'Rosy.Task.within' with the name of its
-- definition. Wrapping only right-hand sides would not suffice: after @turn@ in @do { turn; … }@ the enclosing definition is active again.
--
-- The expression is wrapped as a function of unit. A recursion like @loop n = step >> loop (n + 1)@ creates ever more tasks, and a
-- shared task would retain its successor, and so all of them.
module Rosy.Worker.Ghc.TaskAttribution
  ( taskAttribution,
  )
where

import Control.Monad.IO.Class (liftIO)
import GHC.Builtin.Types (unitTy)
import GHC.Core
import GHC.Core.Make (mkStringExpr, mkWildValBinder)
import GHC.Core.TyCon (TyCon)
import GHC.Core.Type (Type, splitTyConApp_maybe)
import GHC.Core.Utils (exprType)
import GHC.Driver.Plugins (Plugin)
import GHC.Plugins ()
import GHC.Types.Name
import GHC.Types.Var (Id)
import Rosy.Worker.Ghc.Compat.Driver
import Rosy.Worker.Ghc.Compat.Types

-- | A pass over the desugared program, before optimisation.
taskAttribution :: Plugin
taskAttribution = corePlugin "task attribution" attributeTasks

attributeTasks :: ModGuts -> CoreM ModGuts
attributeTasks guts = do
  env <- getHscEnv
  found <- liftIO ((,) <$> origin env "Rosy.Core" (mkTcOcc "Task") <*> origin env "Rosy.Task" (mkVarOcc "within"))
  case found of
    (Just taskName, Just withinName) | any isWritten (bindersOfBinds (mg_binds guts)) -> do
      library <- Library <$> lookupTyCon taskName <*> lookupId withinName
      binds <- mapM (bind library Nothing) (mg_binds guts)
      pure guts {mg_binds = binds}
    _ -> pure guts

-- | The original name of a library entity.
origin :: HscEnv -> String -> OccName -> IO (Maybe Name)
origin env m occ = findModuleNamed env m >>= mapM (\modul -> originalName env modul occ)

data Library = Library {taskType :: TyCon, within :: Id}

-- | Whether a name is a top-level name of the source.
isWritten :: Id -> Bool
isWritten b = isExternalName (getName b) && take 1 (getOccString b) /= "$"

-- | Bindings within the definition of the given name, if any. GHC may bind parts of a definition under generated names.
bind :: Library -> Maybe String -> CoreBind -> CoreM CoreBind
bind library owner group = case group of
  NonRec b e -> NonRec b <$> rightSide b e
  Rec pairs -> Rec <$> mapM (\(b, e) -> (,) b <$> rightSide b e) pairs
  where
    rightSide b = whole library (if isWritten b then Just (getOccString b) else owner)

-- | A complete expression: a right-hand side, a function body, an argument.
whole :: Library -> Maybe String -> CoreExpr -> CoreM CoreExpr
whole library owner e = case (e, owner) of
  (Lam b body, _) -> Lam b <$> whole library owner body
  (_, Just name) | Just result <- taskOf library (exprType e) -> do
    text <- mkStringExpr name
    inner <- parts library owner e
    pure (mkApps (Var (within library)) [Type result, text, Lam (mkWildValBinder manyType unitTy) inner])
  _ -> parts library owner e

parts :: Library -> Maybe String -> CoreExpr -> CoreM CoreExpr
parts library owner e = case e of
  App f x
    | isTypeArg x -> (`App` x) <$> parts library owner f
    | otherwise -> App <$> parts library owner f <*> whole library owner x
  Lam b body -> Lam b <$> whole library owner body
  Let group body -> Let <$> bind library owner group <*> parts library owner body
  Case scrutinee b t alternatives -> do
    scrutinee' <- parts library owner scrutinee
    Case scrutinee' b t <$> mapM (\(Alternative con vars body) -> Alternative con vars <$> parts library owner body) alternatives
  Cast body co -> (`Cast` co) <$> parts library owner body
  Tick note body -> Tick note <$> parts library owner body
  _ -> pure e

-- | The result type of a task type.
taskOf :: Library -> Type -> Maybe Type
taskOf library t = case splitTyConApp_maybe t of
  Just (con, [result]) | con == taskType library -> Just result
  _ -> Nothing
