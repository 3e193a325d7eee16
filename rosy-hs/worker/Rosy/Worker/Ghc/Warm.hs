-- |
-- Module      : Rosy.Worker.Ghc.Warm
-- Description : One compiler session, prepared once and used by every forked child.
--
-- Reads the package databases, loads the interfaces a program may need, and links Rosy into this process, so that a
-- child finds all of it in its memory.
module Rosy.Worker.Ghc.Warm
  ( -- * Where things are
    Library (..),

    -- * The session
    Session (..),
    Launcher,
    warm,
    defaultExtensions,
  )
where

import Control.Monad (forM_)
import Control.Monad.IO.Class (liftIO)
import qualified Data.Set as Set
import qualified Data.Text as Text
import Data.Word (Word32)
import Foreign.C.Types (CInt)
import Foreign.Ptr (Ptr)
import GHC hiding (Warning)
import qualified GHC.Data.EnumSet as EnumSet
import GHC.Driver.Finder (findImportedModule)
import GHC.Driver.Main (hscGetModuleInterface)
import GHC.Driver.Session
import GHC.Driver.Types (FindResult (..))
import GHC.Driver.Ways (hostFullWays, wayGeneralFlags, wayUnsetGeneralFlags)
import GHC.LanguageExtensions.Type (Extension (..))
import GHC.Types.Avail (availNames)
import GHC.Types.Name (nameOccName)
import GHC.Types.Name.Occurrence (emptyOccSet, mkOccSet)
import Rosy.Worker.Allow (allowedModules)
import Rosy.Worker.Ghc.Add (Brought (..))
import Unsafe.Coerce (unsafeCoerce)

-- | The databases that list the Rosy library besides the global one, its unit's name there, GHC's own directory.
data Library = Library
  { packageDatabases :: [FilePath],
    unitName :: String,
    compilerDirectory :: FilePath
  }

-- | @Rosy.Launch.onPipe@: the link's descriptor, the page that names the function at work, the program.
type Launcher = CInt -> Ptr Word32 -> IO () -> IO ()

-- | A warm compiler, the launcher of the library linked in this process, and the names that programs have without asking.
data Session = Session
  { environment :: HscEnv,
    launcher :: Launcher,
    brought :: Brought
  }

warm :: Library -> IO Session
warm library = runGhc (Just (compilerDirectory library)) $ do
  plain <- getSessionDynFlags
  (flags, _, _) <- parseDynamicFlags (interpreting plain) (map noLoc arguments)
  _ <- setSessionDynFlags (settle flags)
  setContext (map (IIDecl . qualifiedImport) ["Prelude", "Rosy", "Rosy.Launch", "Foreign.C.Types", "Data.Word", "Foreign.Ptr"])
  onPipe <- compileExpr "Rosy.Launch.onPipe :: Foreign.C.Types.CInt -> Foreign.Ptr.Ptr Data.Word.Word32 -> Prelude.IO () -> Prelude.IO ()"
  setContext []
  env <- getSession
  names <- liftIO (preload env)
  -- Compiled at exactly this type a line ago, in this process and from the same base.
  pure (Session env (unsafeCoerce onPipe) names)
  where
    arguments =
      ["-package-env", "-", "-no-user-package-db", "-hide-all-packages"]
        ++ concat [["-package-db", db] | db <- packageDatabases library]
        ++ ["-package-id", unitName library]
        ++ concat [["-package", p] | p <- ["base", "containers", "random"]]
    qualifiedImport m = (simpleImportDecl (mkModuleName m)) {ideclQualified = QualifiedPre}

-- | Bytecode in memory, for the way in which this process itself is linked.
interpreting :: DynFlags -> DynFlags
interpreting plain = foldl gopt_unset (foldl gopt_set flags (concatMap (wayGeneralFlags platform) own)) (concatMap (wayUnsetGeneralFlags platform) own)
  where
    own = hostFullWays
    platform = targetPlatform plain
    flags = plain {ghcMode = CompManager, ghcLink = LinkInMemory, hscTarget = HscInterpreted, ways = own, verbosity = 0}

-- | Loads the interface of everything that may be imported; gives the names that every program has.
preload :: HscEnv -> IO Brought
preload env = do
  forM_ (Set.toList allowedModules) (interfaceOf . Text.unpack)
  Brought <$> namesOf "Rosy" <*> namesOf "Prelude"
  where
    namesOf m = maybe emptyOccSet (mkOccSet . map nameOccName . concatMap availNames . mi_exports) <$> interfaceOf m
    interfaceOf m = do
      found <- findImportedModule env (mkModuleName m) Nothing
      case found of
        Found _ modul -> Just <$> hscGetModuleInterface env modul
        _ -> pure Nothing

-- | What every program is compiled with. Type errors and unknown names are put off, so that one mistake does not
-- hide the others and the types of the rest of the program are known; nothing with errors ever runs.
settle :: DynFlags -> DynFlags
settle flags =
  flip (foldl xopt_unset) [ForeignFunctionInterface]
    . flip (foldl xopt_set) defaultExtensions
    . flip (foldl gopt_set) [Opt_DeferTypeErrors, Opt_DeferTypedHoles, Opt_DeferOutOfScopeVariables]
    . flip (foldl gopt_unset) [Opt_ShowValidHoleFits]
    $ flags {warningFlags = EnumSet.fromList warnings, safeHaskell = Sf_Safe, useUnicode = True, pprCols = 100}
  where
    warnings =
      [ Opt_WarnIncompletePatterns,
        Opt_WarnIncompleteUniPatterns,
        Opt_WarnOverlappingPatterns,
        Opt_WarnTabs,
        Opt_WarnMissingFields,
        Opt_WarnMissingMethods,
        Opt_WarnDeferredTypeErrors,
        Opt_WarnDeferredOutOfScopeVariables,
        Opt_WarnTypedHoles
      ]

-- | Extensions that are on in every program: what a beginner meets without asking for it.
defaultExtensions :: [Extension]
defaultExtensions =
  [ BangPatterns,
    BinaryLiterals,
    ConstraintKinds,
    DeriveAnyClass,
    DeriveFoldable,
    DeriveFunctor,
    DeriveGeneric,
    DeriveTraversable,
    DerivingStrategies,
    EmptyCase,
    EmptyDataDeriving,
    ExistentialQuantification,
    FlexibleContexts,
    FlexibleInstances,
    GADTSyntax,
    GeneralizedNewtypeDeriving,
    InstanceSigs,
    KindSignatures,
    LambdaCase,
    MultiParamTypeClasses,
    MultiWayIf,
    NumericUnderscores,
    RankNTypes,
    RecordPuns,
    RecordWildCards,
    ScopedTypeVariables,
    StandaloneDeriving,
    TupleSections,
    TypeApplications,
    TypeOperators,
    UndecidableInstances
  ]
