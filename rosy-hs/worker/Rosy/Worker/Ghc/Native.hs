-- |
-- Module      : Rosy.Worker.Ghc.Native
-- Description : A program as machine code, linked with what drives a robot.
--
-- In: a program that has passed the worker's check. Out: a native file, which begins in "Rosy.Robots.Built". What Rosy adds to a
-- program is added to its tree here too, as a plug-in of the compiler between reading and checking.
module Rosy.Worker.Ghc.Native
  ( Order (..),
    Outcome (..),
    compile,
  )
where

import Control.Monad.IO.Class (liftIO)
import GHC
import GHC.Driver.Plugins (Plugin (..), PluginWithArgs (..), StaticPlugin (..), defaultPlugin, purePlugin)
import GHC.Driver.Session (defaultFatalMessager, defaultFlushOut, xopt_set)
import GHC.Driver.Types (HsParsedModule (..))
import GHC.Types.Name (nameOccName)
import GHC.Types.Name.Occurrence (mkOccSet)
import Rosy.Worker.Ghc.Add (Added (..), Brought (..), Instances (..), addRosy, broughtWith)
import Rosy.Worker.Ghc.Blame (blaming)
import Rosy.Worker.Ghc.Warm (defaultExtensions)

data Order = Order
  { -- | GHC's own directory
    compilerDirectory :: FilePath,
    packageDatabase :: FilePath,
    -- | the language's and the robots' names in the database
    units :: [String],
    -- | for what is made on the way; libraries that lie there are taken before the system's
    scratch :: FilePath,
    source :: FilePath,
    -- | where Rosy and its simulator are
    home :: FilePath,
    binary :: FilePath
  }

data Outcome
  = Built
  | -- | The program's first line calls it something else than Main.
    NotMain String
  | -- | The compiler has said on standard error why.
    NotBuilt

-- | Where the made file begins. The program itself stays @Main@, as in every other run.
launcherName :: String
launcherName = "RosyLauncher"

launcherText :: Order -> String
launcherText order =
  unlines
    [ "module " ++ launcherName ++ " (main) where",
      "import qualified Control.Monad",
      "import qualified Main",
      "import qualified Rosy.Robots.Built",
      "main :: IO ()",
      "main = Rosy.Robots.Built.built " ++ show (home order) ++ " (Control.Monad.void Main.main)"
    ]

compile :: Order -> IO Outcome
compile order = defaultErrorHandler defaultFatalMessager defaultFlushOut . runGhc (Just (compilerDirectory order)) $ do
  plain <- getSessionDynFlags
  (parsed, _, _) <- parseDynamicFlags plain (map noLoc (arguments order))
  let flags = foldl xopt_set parsed {ghcMode = CompManager, ghcLink = LinkBinary, hscTarget = HscAsm, verbosity = 0} defaultExtensions
  _ <- setSessionDynFlags flags
  names <- broughtNames
  _ <- setSessionDynFlags flags {staticPlugins = [adding names, blaming]}
  program' <- guessTarget (source order) Nothing
  setTargets [program']
  graph <- depanal [] False
  case [n | m <- mgModSummaries graph, let n = moduleNameString (ms_mod_name m), n /= "Main"] of
    n : _ -> pure (NotMain n)
    [] -> do
      let launcher = scratch order ++ "/" ++ launcherName ++ ".hs"
      liftIO (writeFile launcher (launcherText order))
      start <- guessTarget launcher Nothing
      setTargets [program', start]
      done <- load LoadAllTargets
      pure (if succeeded done then Built else NotBuilt)

-- | Threads and yields, so that what watches over the robot goes on beside a program that only computes.
arguments :: Order -> [String]
arguments order =
  ["-package-env", "-", "-no-user-package-db", "-hide-all-packages", "-package-db", packageDatabase order]
    ++ concat [["-package-id", u] | u <- units order]
    ++ concat [["-package", p] | p <- ["base", "containers", "random"]]
    ++ ["-O1", "-threaded", "-fno-omit-yields", "-rtsopts=ignoreAll", "-w"]
    ++ ["-main-is", launcherName, "-L" ++ scratch order, "-outputdir", scratch order, "-o", binary order]

-- | What every program has.
broughtNames :: Ghc Brought
broughtNames = Brought <$> exportsOf "Rosy" <*> exportsOf "Prelude"
  where
    exportsOf m = do
      info <- findModule (mkModuleName m) Nothing >>= getModuleInfo
      pure (mkOccSet (maybe [] (map nameOccName . modInfoExports) info))

adding :: Brought -> StaticPlugin
adding names = StaticPlugin (PluginWithArgs defaultPlugin {parsedResultAction = const add, pluginRecompile = purePlugin} [])
  where
    add summary tree
      | moduleNameString (ms_mod_name summary) == "Main" = pure tree {hpm_module = fmap (program . addRosy Whole (const True) (broughtWith (ms_hspp_opts summary) names)) (hpm_module tree)}
      | otherwise = pure tree
