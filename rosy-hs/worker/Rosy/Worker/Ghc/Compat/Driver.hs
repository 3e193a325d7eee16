{-# LANGUAGE CPP #-}
{-# LANGUAGE RankNTypes #-}
-- Which module exports a name differs between versions.
{-# OPTIONS_GHC -Wno-unused-imports -Wno-name-shadowing #-}

-- |
-- Module      : Rosy.Worker.Ghc.Compat.Driver
-- Description : Compatibility layer over GHC's driver: flags, plugins, parsing, type checking, linking; for GHC 9.0, 9.4, 9.6 and newer.
module Rosy.Worker.Ghc.Compat.Driver
  ( -- * The environment
    withFlags,
    addPlugins,
    silenced,
    findModuleNamed,
    originalName,
    libraryValue,

    -- * Flags
    parseArguments,
    interpretedCode,
    nativeCode,
    recordPuns,
    onlyWarnings,
    SafeHaskellMode (..),

    -- * Stages
    CompilerDiagnostic,
    readPragmas,
    applyPragmas,
    parseText,
    isSafeImport,
    mainSummary,
    typecheck,
    desugarDiagnostics,
    compileAndLink,
    unloadAll,

    -- * Plugins
    treePlugin,
    corePlugin,
    holePlugin,
    zonked,

    -- * Native builds
    sourceTarget,

    -- * Re-exports
    HscEnv (..),
    ModGuts (..),
    ModSummary (..),
    HsParsedModule (..),
    ForeignStubs (..),
    StaticPlugin (..),
    MonadThings (..),
    TyThing (..),
    ModIface,
    mi_exports,
    lookupTypeEnv,
    typeEnvIds,
    typeEnvTyCons,
    HoleFitCandidate (..),
    TypedHole (..),
    CoreM,
    getHscEnv,
  )
where

import Control.Exception (evaluate, try)
import Control.Monad (void)
import Control.Monad.IO.Class (liftIO)
import Data.Either (fromRight)
import Data.Time.Calendar (fromGregorian)
import Data.Time.Clock (UTCTime (..))
import GHC (Ghc, Target, guessTarget, parseDynamicFlags)
import GHC.Core.Opt.Monad
import GHC.Core.TyCo.Rep (Type)
import GHC.Data.Bag (Bag, bagToList, listToBag)
import qualified GHC.Data.EnumSet as EnumSet
import GHC.Data.FastString (mkFastString)
import GHC.Data.StringBuffer (StringBuffer)
import GHC.Driver.Main hiding (getHscEnv)
import GHC.Driver.Plugins
import GHC.Driver.Session
import GHC.Hs hiding (Warning)
import GHC.HsToCore.Binds (dsTopLHsBinds)
import GHC.HsToCore.Monad (initDs)
import GHC.LanguageExtensions.Type (Extension (..))
import GHC.Parser (parseModule)
import GHC.Parser.Header (getOptions)
import GHC.Parser.Lexer
import GHC.Tc.Errors.Hole.FitTypes
import GHC.Tc.Module (tcRnModule)
import GHC.Tc.Types
import GHC.Tc.Utils.Monad (newTcRef)
import GHC.Types.Id (Id)
import GHC.Types.Name
import GHC.Types.SrcLoc
import GHC.Unit.Module (Module, mkModuleName)
import GHC.Unit.Module.Location (ModLocation (..))
import GHCi.RemoteTypes (ForeignHValue)
import Rosy.Worker.Ghc.Compat.Syntax
#if __GLASGOW_HASKELL__ >= 904
import GHC.Driver.Backend
import GHC.Driver.Config.Parser (initParserOpts)
import GHC.Driver.Env
import GHC.Driver.Errors.Types
import GHC.Fingerprint (fingerprint0)
import GHC.Iface.Env (lookupNameCache)
import GHC.Linker.Loader (loadName, unload)
import GHC.Linker.Types (Linkable (..), Unlinked (..))
import GHC.Platform.Ways (hostFullWays, wayGeneralFlags, wayUnsetGeneralFlags)
import GHC.Types.Error
import GHC.Types.ForeignStubs (ForeignStubs (..))
import GHC.Types.SafeHaskell (SafeHaskellMode (..))
import GHC.Types.PkgQual (PkgQual (NoPkgQual))
import GHC.Types.SourceError
import GHC.Types.SourceFile (HscSource (..))
import GHC.Types.TyThing (MonadThings (..), TyThing (..))
import GHC.Types.TypeEnv
import GHC.Unit.Finder (FindResult (..), findImportedModule)
import GHC.Unit.Home (mkHomeModule)
import GHC.Unit.Home.ModInfo
import GHC.Unit.Module.Graph (ModuleGraphNode (..), mkModuleGraph)
import GHC.Unit.Module.ModGuts (CgGuts, ModGuts (..))
import GHC.Unit.Module.ModIface (ModIface, emptyFullModIface, mi_deps, mi_exports)
import GHC.Unit.Module.ModSummary (ModSummary (..))
import GHC.Utils.Logger (pushLogHook)
#else
import GHC.Driver.Finder (findImportedModule)
import GHC.Driver.Types
import GHC.Driver.Ways (hostFullWays, wayGeneralFlags, wayUnsetGeneralFlags)
import GHC.Iface.Env (lookupOrigIO)
import GHC.Iface.Tidy (tidyProgram)
import GHC.Parser.Annotation (ApiAnns (..))
import GHC.Runtime.Linker (getHValue, unload)
import GHC.Utils.Error (ErrMsg)
#endif
#if __GLASGOW_HASKELL__ >= 906
import GHC.Core.Opt.Pipeline.Types (CoreToDo (..))
#endif
#if __GLASGOW_HASKELL__ >= 908
import GHC.Tc.Errors.Hole.Plugin
import GHC.Tc.Utils.Monad (liftZonkM)
import GHC.Tc.Zonk.TcType (zonkTcType)
#else
import GHC.Tc.Utils.TcMType (zonkTcType)
#endif

-- * The environment

-- | One message of the compiler.
#if __GLASGOW_HASKELL__ >= 904
type CompilerDiagnostic = MsgEnvelope GhcMessage
#else
type CompilerDiagnostic = ErrMsg
#endif

withFlags :: DynFlags -> HscEnv -> HscEnv

-- | Adds plugins of our own.
addPlugins :: [Plugin] -> HscEnv -> HscEnv

-- | Without output on the terminal.
silenced :: HscEnv -> HscEnv

-- | A module that a program may import.
findModuleNamed :: HscEnv -> String -> IO (Maybe Module)

-- | The name of an entity in its defining module.
originalName :: HscEnv -> Module -> OccName -> IO Name
#if __GLASGOW_HASKELL__ >= 904
withFlags = hscSetFlags

addPlugins ps env = env {hsc_plugins = known {staticPlugins = map static ps ++ staticPlugins known}}
  where
    known = hsc_plugins env

silenced env = env {hsc_logger = pushLogHook (\_ _ _ _ _ -> pure ()) (hsc_logger env)}

findModuleNamed env m = do
  found <- findImportedModule env (mkModuleName m) NoPkgQual
  pure (case found of Found _ modul -> Just modul; _ -> Nothing)

originalName env = lookupNameCache (hsc_NC env)
#else
withFlags flags env = env {hsc_dflags = flags}

addPlugins ps env = env {hsc_dflags = flags {staticPlugins = map static ps ++ staticPlugins flags}}
  where
    flags = hsc_dflags env

silenced env = env {hsc_dflags = (hsc_dflags env) {log_action = \_ _ _ _ _ -> pure ()}}

findModuleNamed env m = do
  found <- findImportedModule env (mkModuleName m) Nothing
  pure (case found of Found _ modul -> Just modul; _ -> Nothing)

originalName = lookupOrigIO
#endif

static :: Plugin -> StaticPlugin
static p = StaticPlugin (PluginWithArgs p [])

-- * Flags

-- | Flags after command line arguments.
parseArguments :: HscEnv -> DynFlags -> [String] -> Ghc DynFlags
#if __GLASGOW_HASKELL__ >= 904
parseArguments env flags arguments = (\(parsed, _, _) -> parsed) <$> parseDynamicFlags (hsc_logger env) flags (map noLoc arguments)
#else
parseArguments _ flags arguments = (\(parsed, _, _) -> parsed) <$> parseDynamicFlags flags (map noLoc arguments)
#endif

-- | The language that GHC 9.0 starts with. Later ones start with GHC2021, in which the same text may mean something else: a type variable that
-- begins with an underscore is a wildcard there.
sameLanguage :: DynFlags -> DynFlags
#if __GLASGOW_HASKELL__ >= 904
sameLanguage flags = lang_set flags (Just Haskell2010) `xopt_set` NondecreasingIndentation `xopt_unset` DatatypeContexts
#else
sameLanguage = id
#endif

-- | Flags for bytecode in memory, for the way in which this process is linked.
interpretedCode :: DynFlags -> DynFlags
interpretedCode plain = foldl gopt_unset (foldl gopt_set flags (concatMap (wayGeneralFlags platform) own)) (concatMap (wayUnsetGeneralFlags platform) own)
  where
    own = hostFullWays
    platform = targetPlatform plain
    flags = withInterpreter (sameLanguage plain) {ghcMode = CompManager, ghcLink = LinkInMemory, verbosity = 0}

-- | Flags for machine code in an executable.
nativeCode :: DynFlags -> DynFlags
nativeCode plain = withCodeGenerator (sameLanguage plain) {ghcMode = CompManager, ghcLink = LinkBinary, verbosity = 0}

withInterpreter, withCodeGenerator :: DynFlags -> DynFlags
#if __GLASGOW_HASKELL__ >= 906
withInterpreter flags = flags {backend = interpreterBackend, targetWays_ = hostFullWays}
withCodeGenerator flags = flags {backend = ncgBackend}
#elif __GLASGOW_HASKELL__ >= 904
withInterpreter flags = flags {backend = Interpreter, targetWays_ = hostFullWays}
withCodeGenerator flags = flags {backend = NCG}
#else
withInterpreter flags = flags {hscTarget = HscInterpreted, ways = hostFullWays}
withCodeGenerator flags = flags {hscTarget = HscAsm}
#endif

-- | These warnings and no others. From GHC 9.8 on there are also categories, which are on: that of functions such as @head@, and deprecations.
onlyWarnings :: [WarningFlag] -> DynFlags -> DynFlags
#if __GLASGOW_HASKELL__ >= 908
onlyWarnings warnings flags = wopt_unset_all_custom flags {warningFlags = EnumSet.fromList warnings}
#else
onlyWarnings warnings flags = flags {warningFlags = EnumSet.fromList warnings}
#endif

-- | The extension NamedFieldPuns.
recordPuns :: Extension
#if __GLASGOW_HASKELL__ >= 904
recordPuns = NamedFieldPuns
#else
recordPuns = RecordPuns
#endif

-- * Stages

-- | The options in the pragmas at the top of a text.
readPragmas :: DynFlags -> StringBuffer -> FilePath -> IO (Either [CompilerDiagnostic] [Located String])
readPragmas flags buffer file = trySource $ do
  let options = pragmaOptions flags buffer file
  mapM_ (evaluate . length . unLoc) options
  pure options

pragmaOptions :: DynFlags -> StringBuffer -> FilePath -> [Located String]
#if __GLASGOW_HASKELL__ >= 904
pragmaOptions flags buffer file = snd (getOptions (initParserOpts flags) buffer file)
#else
pragmaOptions = getOptions
#endif

-- | Flags after such options.
applyPragmas :: DynFlags -> [Located String] -> IO (Either [CompilerDiagnostic] DynFlags)
applyPragmas flags options = trySource ((\(changed, _, _) -> changed) <$> parseDynamicFilePragma flags options)

-- | The errors that the compiler throws.
trySource :: IO a -> IO (Either [CompilerDiagnostic] a)
trySource action = either (Left . thrown) Right <$> try action

thrown :: SourceError -> [CompilerDiagnostic]
#if __GLASGOW_HASKELL__ >= 904
thrown = bagToList . getMessages . srcErrorMessages
#else
thrown = bagToList . srcErrorMessages
#endif

-- | A value of the library by its module and name; loads the interface.
libraryValue :: HscEnv -> String -> String -> IO (Maybe Id)
libraryValue env m name = do
  found <- findModuleNamed env m
  thing <- maybe (pure Nothing) (\modul -> originalName env modul (mkVarOcc name) >>= hscTcRcLookupName env) found
  pure (case thing of Just (AnId i) -> Just i; _ -> Nothing)

-- | Whether Safe Haskell trusts a module. GHC 9.4 and newer throws where 9.0 answers.
isSafeImport :: HscEnv -> Module -> SrcSpan -> IO Bool
isSafeImport env m at = fromRight False <$> trySource (hscCheckSafe env m at)

-- | The tree of a text with warnings, or errors.
parseText :: DynFlags -> StringBuffer -> FilePath -> Either [CompilerDiagnostic] (Located SyntaxTree, [CompilerDiagnostic])
#if __GLASGOW_HASKELL__ >= 904
parseText flags buffer file = case unP parseModule (initParserState (initParserOpts flags) buffer (mkRealSrcLoc (mkFastString file) 1 1)) of
  POk state tree
    | errors@(_ : _) <- found (getPsErrorMessages state) -> Left errors
    | otherwise -> Right (tree, found (fst (getPsMessages state)))
  PFailed state -> Left (found (getPsErrorMessages state))
  where
    found = map (fmap GhcPsMessage) . bagToList . getMessages
#else
parseText flags buffer file = case unP parseModule (mkPState flags buffer (mkRealSrcLoc (mkFastString file) 1 1)) of
  POk state tree
    | errors@(_ : _) <- bagToList (getErrorMessages state flags) -> Left errors
    | otherwise -> Right (tree, bagToList (fst (getMessages state flags)))
  PFailed state -> Left (bagToList (getErrorMessages state flags))
#endif

-- | The module @Main@ with this text.
mainSummary :: HscEnv -> FilePath -> StringBuffer -> ModSummary
#if __GLASGOW_HASKELL__ >= 904
mainSummary env file buffer =
  ModSummary
    { ms_mod = mkHomeModule (hsc_home_unit env) (mkModuleName "Main"),
      ms_hsc_src = HsSrcFile,
      ms_location = ModLocation {ml_hs_file = Just file, ml_hi_file = "Main.hi", ml_dyn_hi_file = "Main.dyn_hi", ml_obj_file = "Main.o", ml_dyn_obj_file = "Main.dyn_o", ml_hie_file = "Main.hie"},
      ms_hs_hash = fingerprint0,
      ms_dyn_obj_date = Nothing,
      ms_ghc_prim_import = False,
      ms_iface_date = Nothing,
      ms_obj_date = Nothing,
      ms_hie_date = Nothing,
      ms_parsed_mod = Nothing,
      ms_srcimps = [],
      ms_textual_imps = [],
      ms_hspp_file = file,
      ms_hspp_opts = hsc_dflags env,
      ms_hspp_buf = Just buffer
    }
#else
mainSummary env file buffer =
  ModSummary
    { ms_mod = mkHomeModule (hsc_dflags env) (mkModuleName "Main"),
      ms_hsc_src = HsSrcFile,
      ms_location = ModLocation {ml_hs_file = Just file, ml_hi_file = "Main.hi", ml_obj_file = "Main.o", ml_hie_file = "Main.hie"},
      ms_hs_date = UTCTime (fromGregorian 2000 1 1) 0,
      ms_iface_date = Nothing,
      ms_obj_date = Nothing,
      ms_hie_date = Nothing,
      ms_parsed_mod = Nothing,
      ms_srcimps = [],
      ms_textual_imps = [],
      ms_hspp_file = file,
      ms_hspp_opts = hsc_dflags env,
      ms_hspp_buf = Just buffer
    }
#endif

-- | Checks names and types: errors, then warnings, and the checked program unless that is impossible.
typecheck :: HscEnv -> ModSummary -> Located SyntaxTree -> IO ([CompilerDiagnostic], Maybe TcGblEnv)

-- | What the desugarer says about some bindings.
desugarDiagnostics :: HscEnv -> TcGblEnv -> [LHsBind GhcTc] -> IO [CompilerDiagnostic]

-- | Compiles a checked program to bytecode, links it into this process, and gives the value of a name.
compileAndLink :: HscEnv -> ModSummary -> TcGblEnv -> Name -> IO ForeignHValue

-- | Forgets all linked programs.
unloadAll :: HscEnv -> IO ()
#if __GLASGOW_HASKELL__ >= 904
typecheck env summary tree = do
  (messages, outcome) <- tcRnModule env summary False (HsParsedModule tree [])
  pure (errorsFirst (map (fmap GhcTcRnMessage) (bagToList (getMessages messages))), outcome)

desugarDiagnostics env checked binds = do
  (messages, _) <- initDs env checked (dsTopLHsBinds (listToBag binds))
  pure (errorsFirst (map (fmap GhcDsMessage) (bagToList (getMessages messages))))

errorsFirst :: [CompilerDiagnostic] -> [CompilerDiagnostic]
errorsFirst ms = filter ((== SevError) . errMsgSeverity) ms ++ filter ((== SevWarning) . errMsgSeverity) ms

compileAndLink env' summary checked name = do
  let env = silenced env'
  guts <- hscDesugar env summary checked >>= hscSimplify env []
  (tidy, details) <- hscTidy env guts
  (_, bytecode, _) <- hscInteractive env (interactiveGuts tidy) (ms_location summary)
  let code = LM (UTCTime (fromGregorian 2000 1 1) 0) (ms_mod summary) [BCOs bytecode []]
      interface = (emptyFullModIface (ms_mod summary)) {mi_deps = mg_deps guts}
      home = hscUpdateHPT (\table -> addToHpt table (mkModuleName "Main") (HomeModInfo interface details (linkableOf code))) env
  (value, _, _) <- loadName (hscInterp env) home {hsc_mod_graph = mkModuleGraph [ModuleNode [] summary]} name
  pure value

unloadAll env = unload (hscInterp env) env []
#else
typecheck env summary tree = do
  ((warned, failed), outcome) <- tcRnModule env summary False (HsParsedModule tree [] (ApiAnns mempty Nothing mempty mempty))
  pure (bagToList failed ++ bagToList warned, outcome)

desugarDiagnostics env checked binds = do
  ((doubts, failures), _) <- initDs env checked (dsTopLHsBinds (listToBag binds))
  pure (bagToList failures ++ bagToList doubts)

compileAndLink env summary checked name = do
  guts <- hscDesugar env summary checked >>= hscSimplify env []
  (tidy, details) <- tidyProgram env guts
  (_, bytecode, _) <- hscInteractive env tidy (ms_location summary)
  let code = LM (UTCTime (fromGregorian 2000 1 1) 0) (ms_mod summary) [BCOs bytecode []]
      interface = (emptyFullModIface (ms_mod summary)) {mi_deps = mg_deps guts}
  getHValue env {hsc_HPT = addToHpt (hsc_HPT env) (mkModuleName "Main") (HomeModInfo interface details (Just code))} name

unloadAll env = unload env []
#endif

#if __GLASGOW_HASKELL__ >= 906
interactiveGuts :: CgGuts -> CgInteractiveGuts
interactiveGuts = mkCgInteractiveGuts

linkableOf :: Linkable -> HomeModLinkable
linkableOf code = HomeModLinkable {homeMod_bytecode = Just code, homeMod_object = Nothing}
#elif __GLASGOW_HASKELL__ >= 904
interactiveGuts :: CgGuts -> CgGuts
interactiveGuts = id

linkableOf :: Linkable -> Maybe Linkable
linkableOf = Just
#endif

-- * Plugins

-- | Changes the parsed tree of every module.
treePlugin :: (ModSummary -> SyntaxTree -> SyntaxTree) -> Plugin
#if __GLASGOW_HASKELL__ >= 904
treePlugin change = defaultPlugin {parsedResultAction = \_ summary result -> pure result {parsedResultModule = changeTree (change summary) (parsedResultModule result)}, pluginRecompile = purePlugin}
#else
treePlugin change = defaultPlugin {parsedResultAction = \_ summary result -> pure (changeTree (change summary) result), pluginRecompile = purePlugin}
#endif

changeTree :: (SyntaxTree -> SyntaxTree) -> HsParsedModule -> HsParsedModule
changeTree change tree = tree {hpm_module = fmap change (hpm_module tree)}

-- | A pass over Core, before all others.
corePlugin :: String -> (ModGuts -> CoreM ModGuts) -> Plugin
corePlugin name pass = defaultPlugin {installCoreToDos = \_ passes -> pure (CoreDoPluginPass name pass : passes), pluginRecompile = purePlugin}

-- | Is shown every hole with the names in scope.
holePlugin :: (TypedHole -> [HoleFitCandidate] -> TcM ()) -> Plugin
holePlugin look = defaultPlugin {holeFitPlugin = const (Just (HoleFitPluginR (newTcRef ()) (const (HoleFitPlugin (\hole inScope -> [] <$ look hole inScope) (\_ fits -> pure fits))) (const (pure ()))))}

-- | A type with everything that is known of its variables.
zonked :: Type -> TcM Type
#if __GLASGOW_HASKELL__ >= 908
zonked = liftZonkM . zonkTcType
#else
zonked = zonkTcType
#endif

-- * Native builds

sourceTarget :: FilePath -> Ghc Target
#if __GLASGOW_HASKELL__ >= 904
sourceTarget file = guessTarget file Nothing Nothing
#else
sourceTarget file = guessTarget file Nothing
#endif
