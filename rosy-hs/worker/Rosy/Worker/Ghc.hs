{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE RankNTypes #-}
{-# LANGUAGE ScopedTypeVariables #-}

-- |
-- Module      : Rosy.Worker.Ghc
-- Description : Interface to the compiler.
--
-- Analyses and loads programs. Only this module and its folder import the GHC API; all exported types are independent of it.
module Rosy.Worker.Ghc
  ( -- * A session
    Library (..),
    Session,
    start,
    compilerVersion,

    -- * Asking
    Restriction (..),
    Purpose (..),
    Analysis (..),
    analyseProgram,
    complete,

    -- * Running
    Ready,
    EmptyPlace,
    load,
    forgetPrograms,
    asMain,
  )
where

import Control.Monad (void)
import Data.List (nub)
import Data.Maybe (mapMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Data.Word (Word32)
import Foreign.C.Types (CInt)
import Foreign.Ptr (Ptr)
import GHC.Data.Bag (bagToList)
import GHC.Data.StringBuffer (stringToStringBuffer)
import GHC.Driver.Plugins (Plugin)
import GHC.Driver.Session (DynFlags (..), xopt_set)
import GHC.LanguageExtensions.Type (Extension (ForeignFunctionInterface))
import GHC.Settings.Config (cProjectVersion)
import GHC.Tc.Types (TcGblEnv (..))
import GHC.TopHandler (runMainIO)
import GHC.Types.Name (Name, getName, getOccString, nameModule_maybe)
import GHC.Types.SrcLoc
import GHCi.RemoteTypes (localRef, withForeignRef)
import Rosy.Worker.Branch (Branch)
import Rosy.Worker.CompilerMessage (Category (Hole, MissingMethods, Types), CompilerMessage (..), ProgramOutline (..), emptyOutline)
import Rosy.Worker.Ghc.BranchInstrumentation
import Rosy.Worker.Ghc.Compat.Driver
import Rosy.Worker.Ghc.Compat.Syntax
import Rosy.Worker.Ghc.Completion
import Rosy.Worker.Ghc.ConnectionChecks
import Rosy.Worker.Ghc.DeclarationWarnings
import Rosy.Worker.Ghc.Declarations
import Rosy.Worker.Ghc.DeclaredTypes (InstanceBodies (..), ownDefaults)
import Rosy.Worker.Ghc.Diagnostics
import Rosy.Worker.Ghc.DuplicateSimulate
import Rosy.Worker.Ghc.FiniteDefault
import Rosy.Worker.Ghc.FunctionNames (functionNames)
import Rosy.Worker.Ghc.Parsing
import Rosy.Worker.Ghc.ProgramFacts (programFacts)
import Rosy.Worker.Ghc.ProgramGraph (programGraph)
import Rosy.Worker.Ghc.Session
import Rosy.Worker.Ghc.SpanTypes
import Rosy.Worker.Ghc.SyntaxGroups (syntaxGroups)
import Rosy.Worker.Ghc.TaskAttribution
import Rosy.Worker.Ghc.TopicConnections (topicConnections)
import Rosy.Worker.Ghc.TreeRewrite
import Rosy.Worker.Graph (Connection, Part)
import Rosy.Worker.Problem (Declaration (..), Function, Position (..), Problem (kind, place, severity), Severity (..), Typed, isError, problemAt, problemNowhere)
import qualified Rosy.Worker.Problem as Placed (Span (end, start))
import Rosy.Worker.Sentence
import Rosy.Worker.StaticAdvice (Facts)
import Rosy.Worker.TabStops (TabStops, tabStopsOf)
import Unsafe.Coerce (unsafeCoerce)

-- | As reported in the worker's @ready@.
compilerVersion :: Text
compilerVersion = Text.pack cProjectVersion

-- | Opens a session and compiles a sample program in it. GHC loads most facts about the library on demand; what is loaded before a fork is
-- shared by every child.
start :: Library -> IO Session
start library = do
  session <- openSession library
  _ <- analyseProgram Restricted ForCheck session warmUpProgram
  practised <- analyseProgram Restricted ForRun session warmUpProgram
  case ready practised of
    Just sample -> do
      _ <- load session False sample
      -- The linker caches linked names: without this every program's main would be that of the sample.
      forgetPrograms session
    Nothing -> pure ()
  _ <- analyseProgram Restricted ForCheck session "hole = _ :: Velocity\nwrong = not hole + \"\" + undefinedName\n"
  _ <- complete session "asked :: Velocity -> Memory Bool -> Velocity\nasked v (Memory m) = \nmain = simulate asked\n" (Position 2 22)
  pure session

-- | A sample program that uses most of the library.
warmUpProgram :: Text
warmUpProgram =
  Text.unlines
    [ "import qualified Data.Map as Map",
      "import Data.List (sortOn)",
      "data Mode = Go | Stop | Turn Double Seconds deriving (Eq, Show, Ord)",
      "data Step = Step { angle :: Double, count :: Int, name :: String }",
      "newtype M1 a = M1 a",
      "type Hit = Bool",
      "accelerate :: Velocity -> Memory Hit -> Velocity",
      "accelerate (Velocity v w) (Memory hit) = if hit then Velocity (v - 0.5) w else Velocity (v + 0.5) w",
      "play :: Bumper -> Maybe Sound",
      "play (Bumper _ Pressed) = Just ErrorSound",
      "play _ = Nothing",
      "data Turned = Turned",
      "edge :: Cliff -> (Led2, Maybe Turned)",
      "edge (Cliff side Hole) = (Led2 (if side == LeftCliff then Orange else Red), Just Turned)",
      "edge _ = (Led2 Black, Nothing)",
      "lifted :: Wheel -> (Led1, Led2, Memory Mode)",
      "lifted (Wheel _ Air) = (Led1 Red, Led2 Red, Memory Stop)",
      "lifted _ = (Led1 Black, Led2 Black, Memory Go)",
      "turned :: Turned -> StdGen -> Seconds -> Memory Mode",
      "turned Turned gen now = Memory (Turn (if left then 1 else -1) (now + doubleToSeconds angle))",
      "  where",
      "    (angle, more) = randomR (0, pi) gen",
      "    (left, _) = random more",
      "spin :: Memory Mode -> Seconds -> Either Velocity (Memory Mode)",
      "spin (Memory (Turn speed end)) now",
      "  | now < end = Left (Velocity 0 speed)",
      "  | otherwise = Right (Memory Go)",
      "spin _ _ = Left (Velocity 0 0)",
      "hits :: Either (Either Bumper Cliff) Wheel -> (Led1, Memory Hit)",
      "hits _ = (Led1 Orange, Memory True)",
      "walk :: Mode -> StdGen -> Seconds -> Memory Mode",
      "walk Stop gen now = Memory (Turn (fst (randomR (0, pi) gen)) (now + 1))",
      "walk (Turn a t) _ now | now > t = Memory Go",
      "walk m _ _ = Memory m",
      "turn :: Double -> Task ()",
      "turn a = task (start a) (run a)",
      "  where start x (Orientation o) = Memory (o + x)",
      "        run x (Memory goal) (Orientation o) = if abs (goal - o) < 0.1 then Left (Done ()) else Right (Velocity 0 (goal - o + x - a))",
      "table :: Map.Map Int String",
      "table = Map.fromList (sortOn fst (zip [1 ..] (words \"one two three\")))",
      "square :: Task ()",
      "square = do { replicateM_ 4 (turn (pi / 2)); say (concatMap show (Map.toList table)); wait 1 }",
      "loose :: Step -> [M1 Int]",
      "loose s = [M1 (count s) | even (count s), let _ = mapM_ print (name s)]",
      "main = if length (show Go) > 3 then simulate (accelerate, play, hits, walk) else if length (show Stop) > 3 then simulate (edge, lifted, turned, spin, play) else simulate square"
    ]

-- | Result of parsing and type checking.
data Analysis = Analysis
  { -- | Problems found by the worker: refused imports, no @main@.
    refusals :: [Problem],
    -- | Messages of the compiler.
    messages :: [CompilerMessage],
    outline :: ProgramOutline,
    -- | Present for a check of a program without errors.
    facts :: Maybe Facts,
    declared :: [Declaration],
    connected :: [Function],
    -- | The network of functions and tasks that @main@ simulates.
    network :: [Part],
    -- | The topics that the program connects its own types to, in the order of the text.
    onTopics :: [Connection],
    typed :: [Typed],
    -- | The composite nodes of the parsed program; absent when it cannot be parsed.
    grouped :: Maybe [Placed.Span],
    -- | Present if the program can run, unless a type error remains that has another cause than an empty place.
    ready :: Maybe Ready
  }

-- | A type-checked program, with its name for @main@, its text, and the places of what the learner wrote in it.
data Ready = Ready HscEnv ModSummary TcGblEnv Name Text (SrcSpan -> Maybe Placed.Span)

-- | Purpose of an analysis: to report problems and types, to run the program, or to run it without warnings. A check is faster than a run.
data Purpose = ForCheck | ForRun | ForPlainRun
  deriving (Eq)

-- | Parses and type-checks a program.
analyseProgram :: Restriction -> Purpose -> Session -> Text -> IO Analysis
analyseProgram restriction purpose session source = do
  options <- programOptions restriction (allowing (hsc_dflags (environment session))) columns source buffer
  case options of
    Left found -> pure (stopped found [])
    Right flags -> case readProgram flags columns buffer of
      Left raws -> pure (stopped [] raws)
      Right (L at parsed, warnings) -> do
        let listed = if restriction == Restricted then treeRefusals columns source parsed else []
        unsafe <- if restriction == Unrestricted || not (null listed) then pure [] else unsafeImports (withFlags flags (environment session)) columns parsed
        let refused = listed ++ unsafe
        found <-
          if null refused
            then check restriction purpose session flags columns source (L at parsed) warnings
            else pure (stopped refused warnings)
        pure found {grouped = Just (syntaxGroups (spanAt columns) parsed)}
  where
    columns = tabStopsOf source
    buffer = stringToStringBuffer (Text.unpack source)
    allowing flags
      | restriction /= Unrestricted = flags
      | otherwise = (xopt_set flags ForeignFunctionInterface) {safeHaskell = Sf_None}
    stopped found raws = Analysis found raws (emptyOutline source) Nothing [] [] [] [] [] Nothing Nothing

-- | Used by tests of the other protections: links a program with foreign calls without the C stubs that GHC would generate and cannot write
-- here.
withoutStubs :: Plugin
withoutStubs = corePlugin "without stubs" (\guts -> pure guts {mg_foreign = NoStubs})

-- * Checking

check :: Restriction -> Purpose -> Session -> DynFlags -> TabStops -> Text -> Located SyntaxTree -> [CompilerMessage] -> IO Analysis
check restriction purpose session flags columns source (L at parsed) warnings = do
  let added = rewriteProgram instances (onLinesContaining (map Text.pack controllerFunctions) source) (implicitNamesWith flags (implicitNames session)) parsed
      env = addPlugins [withoutStubs | restriction == Unrestricted] (withFlags flags (environment session))
      summary = summaryOf env source
      placed = definitionSpans (spanAt columns) parsed
      outlined = (emptyOutline source) {bindings = placed, signatures = signatureSpans (spanAt columns) parsed}
  (diagnostics, outcome) <- typecheck env summary (L at (program added))
  let first = warnings ++ map (completeDerivations . fromTypeChecker flags columns) diagnostics
      names = nub (concatMap functionNames (controllers added))
      connectionErrors = filter isConnectionError . map (fromTypeChecker flags columns)
  others <-
    if any isConnectionError first && length names > 1
      then filter ((`elem` map (Just . snd) placed) . messageSpan) . connectionErrors . fst <$> typecheck env summary (L at (withConnectionChecks (filter (/= "main") names) (program added)))
      else pure []
  let found = first ++ others
      bad = any ((== Error) . messageSeverity)
      hasHoles = any ((== Hole) . category)
      -- All errors of a program with holes may be about types that depend on what is put into them.
      mayBeUnfinished raws = hasHoles raws && all ((== Types) . category) (filter ((== Error) . messageSeverity) raws)
      mains = [() | ("main", _) <- placed]
      connectedTopics = topicConnections parsed
      twice = [(problemAt s "second-simulate" (tr "A program simulates once, and this is the second time.") (tr "Put all functions into one: simulate (f, g); tasks follow one another in a do.")) {severity = Warning} | Just s <- [duplicateSimulate parsed >>= spanAt columns]]
      doubtful = filter (not . isRefused) (declarationWarnings (spanAt columns) (implicitNames session) parsed)
      -- An instance that is refused has one problem.
      isRefused p = kind p == "empty-instance" && or [fmap lineOf (messageSpan m) == fmap lineOf (place p) | m <- found, messageSeverity m == Error]
      lineOf = line . Placed.start
      noMain = [problemNowhere "no-main" (tr "The program does not say what the robot should do.") (case names of [f] -> trWith "Add a line, for example: {code}" ["code" =: "main = simulate " <> Text.pack f]; _ -> tr "Add a line that starts with: main = simulate") | null mains]
      whole raws tcg next =
        let describe spelling = describeFunctions flags spelling (map Text.pack names) tcg
            connections = describe AsWritten
            declarations = describeDeclarations flags placed tcg
            spans = typedSpans tcg
            known = outlined {connectedTo = connections, spelledOut = describe SpelledOut, typesOfNames = [(declares d, ofType d) | d <- declarations]}
         in Analysis (noMain ++ twice ++ doubtful ++ endless tcg) raws known (factsOf raws) declarations connections (if bad raws && not (mayBeUnfinished raws) then [] else programGraph (showType flags) (spanAt columns) connectedTopics parsed tcg spans) connectedTopics (typesAt (showType flags) (spanAt columns) (derivedSpans parsed) spans) Nothing next
      factsOf raws = if purpose == ForCheck && not (bad raws || hasHoles raws) then Just (programFacts (spanAt columns) (`onLinesContaining` source) (`onLinesApplying` source) (map Text.pack names) parsed) else Nothing
      endless tcg =
        [ problemAt s "no-default" (trWith "A memory of ‘{name}’ has no first value." ["name" =: name]) (tr "Every way to make one needs a value that has none either. Add a constructor without fields.")
          | (spot, t) <- memoriesWithoutDefault (ownDefaults parsed) tcg,
            let name = showType flags t,
            Just s <- [spanAt columns spot]
        ]
  case outcome of
    Nothing -> pure (Analysis (noMain ++ doubtful) found outlined Nothing [] [] [] connectedTopics [] Nothing Nothing)
    Just tcg
      | mayBeUnfinished found, not (any isError (noMain ++ endless tcg)), purpose /= ForCheck -> pure (whole found tcg (readyWith tcg env summary))
      | bad found || hasHoles found -> pure (whole found tcg Nothing)
      | otherwise -> do
        -- The desugarer reports missing cases. Derived code has none.
        doubts <- if purpose == ForPlainRun then pure [] else desugarDiagnostics env tcg (filter (isWritten . spanOf) (bagToList (tcg_binds tcg)))
        let raws = found ++ map (fromTypeChecker flags columns) doubts
        pure $
          if bad raws || any isError (noMain ++ endless tcg) || purpose == ForCheck
            then whole raws tcg Nothing
            else whole raws tcg (readyWith tcg env summary)
  where
    readyWith tcg env summary = (\name -> Ready env summary tcg name source (\s -> if isWritten s then spanAt columns s else Nothing)) <$> mainOf tcg
    instances = if purpose == ForCheck then EmptyBodies else WholeBodies
    isWritten = not . isInside (derivedSpans parsed)
    -- An instance without methods fails when it is used. Written by hand it may be on purpose, derived it is not.
    completeDerivations m
      | category m == MissingMethods, Just s <- messageSpan m, any (contains s) (mapMaybe (spanAt columns) (derivedSpans parsed)) = m {messageSeverity = Error}
      | otherwise = m
    contains inner outer = Placed.start outer <= Placed.start inner && Placed.end inner <= Placed.end outer
    mainOf tcg = case [getName i | i <- typeEnvIds (tcg_type_env tcg), getOccString i == "main", nameModule_maybe (getName i) == Just (tcg_mod tcg)] of
      n : _ -> Just n
      [] -> Nothing

-- * Running

-- | Compiles a checked program to bytecode in this process. The result has its branches, and runs it over a link's descriptor, with a shared
-- page for the name of the active function, a mailbox, and the empty places of the program. A plain run has no branches.
load :: Session -> Bool -> Ready -> IO ([Branch], CInt -> Ptr Word32 -> Ptr Word32 -> [EmptyPlace] -> IO ())
load session plain (Ready env summary checked name source place) = do
  (instrumented, branches) <- if plain then pure (checked, []) else instrumentBranches env place source checked
  value <- compileAndLink (addPlugins [taskAttribution] env) summary instrumented name
  -- The type checker has verified that main is an IO action.
  action <- withForeignRef value localRef
  pure (branches, \fd page mailbox places -> launcher session fd page mailbox places branches (void (unsafeCoerce action :: IO ())))

-- | Removes all loaded programs from the linker, which otherwise holds their unlinked code. They can still be run.
forgetPrograms :: Session -> IO ()
forgetPrograms = unloadAll . environment

-- | Runs an action as main thread, which receives heap overflow exceptions.
asMain :: IO () -> IO ()
asMain = runMainIO
