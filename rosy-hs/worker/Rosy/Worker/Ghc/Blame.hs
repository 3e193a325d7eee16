{-# LANGUAGE PatternSynonyms #-}

-- |
-- Module      : Rosy.Worker.Ghc.Blame
-- Description : Says of every task in whose definition it stands.
--
-- What a function does when it fires is blamed on the function. Between two firings the program says which task comes next, and
-- that may never end either: @patrol = forever (pure ())@. When the types are known, every expression of type @Task a@ in the
-- program is wrapped in 'Rosy.Task.within' with the name of its definition. It has to be every one and not only the
-- right-hand side of the definition: after @turn@ in @do { turn; … }@ it is the definition's turn again.
--
-- The expression is wrapped as a function of nothing. A recursion like @loop n = step >> loop (n + 1)@ makes ever more tasks, and a
-- task that was an expression would keep the one it goes on with, and so all of them.
module Rosy.Worker.Ghc.Blame
  ( blaming,
  )
where

import Control.Monad.IO.Class (liftIO)
import GHC.Builtin.Types (unitTy)
import GHC.Core
import GHC.Core.Make (mkStringExpr, mkWildValBinder)
import GHC.Core.Opt.Monad (CoreM, CoreToDo (..), getHscEnv)
import GHC.Core.TyCon (TyCon)
import GHC.Core.Type (Type, splitTyConApp_maybe, pattern Many)
import GHC.Core.Utils (exprType)
import GHC.Driver.Finder (findImportedModule)
import GHC.Driver.Plugins (Plugin (..), PluginWithArgs (..), StaticPlugin (..), defaultPlugin, purePlugin)
import GHC.Driver.Types (FindResult (..), HscEnv, ModGuts (..), MonadThings (..))
import GHC.Iface.Env (lookupOrigIO)
import GHC.Plugins ()
import GHC.Types.Name
import GHC.Types.Var (Id)
import GHC.Unit.Module (mkModuleName)

-- | A pass over the program as the type checker leaves it, before anything is made faster.
blaming :: StaticPlugin
blaming = StaticPlugin (PluginWithArgs defaultPlugin {installCoreToDos = \_ passes -> pure (CoreDoPluginPass "whose task it is" blame : passes), pluginRecompile = purePlugin} [])

blame :: ModGuts -> CoreM ModGuts
blame guts = do
  env <- getHscEnv
  found <- liftIO ((,) <$> origin env "Rosy.Core" (mkTcOcc "Task") <*> origin env "Rosy.Task" (mkVarOcc "within"))
  case found of
    (Just taskName, Just withinName) | any isWritten (bindersOfBinds (mg_binds guts)) -> do
      library <- Library <$> lookupTyCon taskName <*> lookupId withinName
      binds <- mapM (bind library Nothing) (mg_binds guts)
      pure guts {mg_binds = binds}
    _ -> pure guts

-- | Where a name of the library comes from.
origin :: HscEnv -> String -> OccName -> IO (Maybe Name)
origin env m occ = do
  found <- findImportedModule env (mkModuleName m) Nothing
  case found of
    Found _ modul -> Just <$> lookupOrigIO env modul occ
    _ -> pure Nothing

data Library = Library {taskType :: TyCon, within :: Id}

-- | Whether somebody has written this name at top level.
isWritten :: Id -> Bool
isWritten b = isExternalName (getName b) && take 1 (getOccString b) /= "$"

-- | The bindings of the definition with the given name, if they are in one. The compiler may bind the parts of a definition
-- under names of its own.
bind :: Library -> Maybe String -> CoreBind -> CoreM CoreBind
bind library owner group = case group of
  NonRec b e -> NonRec b <$> rightSide b e
  Rec pairs -> Rec <$> mapM (\(b, e) -> (,) b <$> rightSide b e) pairs
  where
    rightSide b = whole library (if isWritten b then Just (getOccString b) else owner)

-- | An expression that stands on its own: a right-hand side, what a function gives, an argument.
whole :: Library -> Maybe String -> CoreExpr -> CoreM CoreExpr
whole library owner e = case (e, owner) of
  (Lam b body, _) -> Lam b <$> whole library owner body
  (_, Just name) | Just result <- taskOf library (exprType e) -> do
    text <- mkStringExpr name
    inner <- parts library owner e
    pure (mkApps (Var (within library)) [Type result, text, Lam (mkWildValBinder Many unitTy) inner])
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
    Case scrutinee' b t <$> mapM (\(con, vars, body) -> (,,) con vars <$> parts library owner body) alternatives
  Cast body co -> (`Cast` co) <$> parts library owner body
  Tick note body -> Tick note <$> parts library owner body
  _ -> pure e

-- | What a task ends with.
taskOf :: Library -> Type -> Maybe Type
taskOf library t = case splitTyConApp_maybe t of
  Just (con, [result]) | con == taskType library -> Just result
  _ -> Nothing
