-- |
-- Module      : Rosy.Worker.Ghc.NativeBuild
-- Description : Native build of a program, linked with the robot drivers.
--
-- Takes a program that has passed the worker's check and produces an executable, whose entry point is "Rosy.Robots.BuiltProgram". The
-- syntax tree is rewritten by a plugin between parsing and type checking.
module Rosy.Worker.Ghc.NativeBuild
  ( BuildRequest (..),
    Outcome (..),
    compile,
  )
where

import Control.Monad.IO.Class (liftIO)
import qualified Data.Set as Set
import GHC
import GHC.Driver.Monad (modifySession)
import GHC.Driver.Plugins (Plugin)
import GHC.Driver.Session (defaultFatalMessager, defaultFlushOut, xopt_set)
import Rosy.Worker.Ghc.Compat.Driver
import Rosy.Worker.Ghc.Compat.Types (exportedName)
import Rosy.Worker.Ghc.DeclaredTypes (InstanceBodies (..))
import Rosy.Worker.Ghc.Session (defaultExtensions)
import Rosy.Worker.Ghc.TaskAttribution (taskAttribution)
import Rosy.Worker.Ghc.TreeRewrite (ImplicitNames (..), Rewritten (..), implicitNamesWith, rewriteProgram)

data BuildRequest = BuildRequest
  { -- | GHC's own directory
    compilerDirectory :: FilePath,
    packageDatabase :: FilePath,
    -- | the language's and the robots' names in the database
    units :: [String],
    -- | folder of intermediate files; libraries in it take precedence over the system's
    scratch :: FilePath,
    source :: FilePath,
    -- | folder of Rosy and its simulator
    home :: FilePath,
    binary :: FilePath,
    -- | whether the C library becomes a part of the executable
    static :: Bool
  }

data Outcome
  = Built
  | -- | The module is not called Main.
    NotMain String
  | -- | GHC has written the reason to standard error.
    NotBuilt

-- | Module of the entry point. The program itself stays @Main@, as in every other run.
launcherName :: String
launcherName = "RosyLauncher"

launcherText :: BuildRequest -> String
launcherText order =
  unlines
    [ "module " ++ launcherName ++ " (main) where",
      "import qualified Control.Monad",
      "import qualified Main",
      "import qualified Rosy.Robots.BuiltProgram",
      "main :: IO ()",
      "main = Rosy.Robots.BuiltProgram.runBuiltProgram " ++ show (home order) ++ " (Control.Monad.void Main.main)"
    ]

compile :: BuildRequest -> IO Outcome
compile order = defaultErrorHandler defaultFatalMessager defaultFlushOut . runGhc (Just (compilerDirectory order)) $ do
  plain <- getSessionDynFlags
  fresh <- getSession
  parsed <- parseArguments fresh plain (arguments order)
  let flags = foldl xopt_set (nativeCode parsed) defaultExtensions
  _ <- setSessionDynFlags flags
  names <- implicitNamesOf
  modifySession (addPlugins [adding names, taskAttribution])
  program' <- sourceTarget (source order)
  setTargets [program']
  graph <- depanal [] False
  case [n | m <- mgModSummaries graph, let n = moduleNameString (ms_mod_name m), n /= "Main"] of
    n : _ -> pure (NotMain n)
    [] -> do
      let launcher = scratch order ++ "/" ++ launcherName ++ ".hs"
      liftIO (writeFile launcher (launcherText order))
      start <- sourceTarget launcher
      setTargets [program', start]
      -- Only now: from 9.4 on GHC also refuses to read a program alone whose main module is another one.
      env <- getSession
      current <- getSessionDynFlags
      linked <- parseArguments env current (linking order)
      _ <- setSessionDynFlags linked
      done <- load LoadAllTargets
      pure (if succeeded done then Built else NotBuilt)

-- | With threads and yields, so that the watchdog keeps running beside a non-terminating program.
arguments :: BuildRequest -> [String]
arguments order =
  ["-package-env", "-", "-no-user-package-db", "-hide-all-packages", "-package-db", packageDatabase order]
    ++ concat [["-package-id", u] | u <- units order]
    ++ concat [["-package", p] | p <- ["base", "containers", "random"]]
    ++ ["-O1", "-threaded", "-fno-omit-yields", "-rtsopts=ignoreAll", "-w"]
    ++ ["-optl-s"]
    ++ ["-optl-static" | static order]
    ++ ["-L" ++ scratch order, "-outputdir", scratch order]

-- | The main module of the executable, and its name.
linking :: BuildRequest -> [String]
linking order = ["-main-is", launcherName, "-o", binary order]

-- | The names in scope of every program. 'robotTypes' serve warnings only, which a build does not give.
implicitNamesOf :: Ghc ImplicitNames
implicitNamesOf = ImplicitNames <$> exportsOf "Rosy" <*> exportsOf "Prelude" <*> pure Set.empty
  where
    exportsOf m = do
      info <- findModule (mkModuleName m) Nothing >>= getModuleInfo
      pure (Set.fromList (maybe [] (map exportedName . modInfoExports) info))

adding :: ImplicitNames -> Plugin
adding names = treePlugin add
  where
    add summary tree
      | moduleNameString (ms_mod_name summary) == "Main" = program (rewriteProgram WholeBodies (const True) (implicitNamesWith (ms_hspp_opts summary) names) tree)
      | otherwise = tree
