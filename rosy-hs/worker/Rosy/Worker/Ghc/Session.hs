-- |
-- Module      : Rosy.Worker.Ghc.Session
-- Description : Compiler session, prepared once and shared by every forked child.
--
-- Reads the package databases, loads the interfaces of all allowed modules, and links the Rosy library into this process.
module Rosy.Worker.Ghc.Session
  ( -- * Library
    Library (..),

    -- * The session
    Session (..),
    Launcher,
    EmptyPlace,
    openSession,
    defaultExtensions,
  )
where

import Control.Monad (forM_)
import Control.Monad.IO.Class (liftIO)
import Data.List (isPrefixOf)
import qualified Data.Set as Set
import qualified Data.Text as Text
import Data.Word (Word32)
import Foreign.C.Types (CInt)
import Foreign.Ptr (Ptr)
import GHC hiding (Warning)
import GHC.Driver.Main (hscGetModuleInterface)
import GHC.Driver.Session
import GHC.LanguageExtensions.Type (Extension (..))
import GHC.Types.Avail (availNames)
import GHC.Types.Name (nameModule_maybe, nameOccName)
import GHC.Types.Name.Occurrence (isTcOcc, occNameString)
import Rosy.Worker.Allowlist (allowedModules)
import Rosy.Worker.Branch (Branch)
import Rosy.Worker.Ghc.Compat.Driver
import Rosy.Worker.Ghc.Compat.Types (exportedName)
import Rosy.Worker.Ghc.TreeRewrite (ImplicitNames (..))
import Unsafe.Coerce (unsafeCoerce)

-- | Package databases of the Rosy library besides the global one, its unit id, and GHC's library directory.
data Library = Library
  { packageDatabases :: [FilePath],
    unitName :: String,
    compilerDirectory :: FilePath
  }

-- | @Rosy.Launch.onPipe@: the link's descriptor, the page that names the function at work, the mailbox, the empty places, the branches, the program.
type Launcher = CInt -> Ptr Word32 -> Ptr Word32 -> [EmptyPlace] -> [Branch] -> IO () -> IO ()

-- | @Rosy.Problem.EmptyPlace@: start and end as line and column, message and hint.
type EmptyPlace = ((Int, Int), (Int, Int), String, String)

-- | The compiler environment, the launcher of the linked library, and the names in scope of every program.
data Session = Session
  { environment :: HscEnv,
    launcher :: Launcher,
    implicitNames :: ImplicitNames
  }

openSession :: Library -> IO Session
openSession library = runGhc (Just (compilerDirectory library)) $ do
  plain <- getSessionDynFlags
  fresh <- getSession
  flags <- parseArguments fresh (interpretedCode plain) arguments
  _ <- setSessionDynFlags (programFlags flags)
  setContext (map (IIDecl . qualifiedImport) ["Prelude", "Rosy", "Rosy.Launch", "Rosy.Problem", "Rosy.BranchCoverage", "Foreign.C.Types", "Data.Word", "Foreign.Ptr"])
  onPipe <- compileExpr "Rosy.Launch.onPipe :: Foreign.C.Types.CInt -> Foreign.Ptr.Ptr Data.Word.Word32 -> Foreign.Ptr.Ptr Data.Word.Word32 -> [Rosy.Problem.EmptyPlace] -> [Rosy.BranchCoverage.Branch] -> Prelude.IO () -> Prelude.IO ()"
  setContext []
  env <- getSession
  names <- liftIO (preload env)
  -- Compiled at exactly this type above, in this process and with the same base.
  pure (Session env (unsafeCoerce onPipe) names)
  where
    arguments =
      ["-package-env", "-", "-no-user-package-db", "-hide-all-packages"]
        ++ concat [["-package-db", db] | db <- packageDatabases library]
        ++ ["-package-id", unitName library]
        ++ concat [["-package", p] | p <- ["base", "containers", "random"]]
    qualifiedImport m = (simpleImportDecl (mkModuleName m)) {ideclQualified = QualifiedPre}

-- | Loads the interfaces of all allowed modules; returns the names in scope of every program.
preload :: HscEnv -> IO ImplicitNames
preload env = do
  forM_ (Set.toList allowedModules) (interfaceOf . Text.unpack)
  ImplicitNames <$> namesOf "Rosy" <*> namesOf "Prelude" <*> typesOf "Rosy"
  where
    typesOf m = maybe Set.empty (Set.fromList . concatMap (types . availNames) . mi_exports) <$> interfaceOf m
    -- A type with its constructors, or an abstract one. A synonym has no constructors either. The excluded ones mean nothing to the robot.
    types names = case map nameOccName (filter isRosys names) of
      t : constructors | isTcOcc t, occNameString t `notElem` ["Cancel", "Never", "World", "TaskOptions", "CallOptions"], not (null constructors) || occNameString t `elem` ["Task", "Call"] -> [t]
      _ -> []
    isRosys n = maybe False (("Rosy" `isPrefixOf`) . moduleNameString . moduleName) (nameModule_maybe n)
    namesOf m = maybe Set.empty (Set.fromList . map exportedName . concatMap availNames . mi_exports) <$> interfaceOf m
    interfaceOf m = do
      found <- findModuleNamed env m
      mapM (hscGetModuleInterface env) found

-- | Flags of every program. Type errors and unknown names are deferred, so that one mistake does not hide the others and the rest of the
-- program has types; a program with errors never runs.
programFlags :: DynFlags -> DynFlags
programFlags flags =
  flip (foldl xopt_unset) [ForeignFunctionInterface]
    . flip (foldl xopt_set) defaultExtensions
    . flip (foldl gopt_set) [Opt_DeferTypeErrors, Opt_DeferTypedHoles, Opt_DeferOutOfScopeVariables]
    . flip (foldl gopt_unset) [Opt_ShowValidHoleFits]
    . onlyWarnings warnings
    $ flags {safeHaskell = Sf_Safe, useUnicode = True, pprCols = 100}
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

-- | Extensions that are on in every program.
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
    DerivingVia,
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
    recordPuns,
    RecordWildCards,
    ScopedTypeVariables,
    StandaloneDeriving,
    TupleSections,
    TypeApplications,
    TypeOperators
  ]
