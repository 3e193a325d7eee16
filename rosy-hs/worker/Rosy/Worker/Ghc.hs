{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE RankNTypes #-}
{-# LANGUAGE ScopedTypeVariables #-}

-- |
-- Module      : Rosy.Worker.Ghc
-- Description : The one door to the compiler.
--
-- A program's text in, what the compiler thinks of it out, and a program that can be started. This module and
-- the folder of its name are the only ones that import the compiler; all that leaves it is in our own nouns.
module Rosy.Worker.Ghc
  ( -- * A session
    Library (..),
    Session,
    start,
    compilerVersion,

    -- * Asking
    Guard (..),
    Aim (..),
    Analysis (..),
    analyse,
    complete,

    -- * Running
    Ready,
    load,
    asMain,
  )
where

import Control.Monad (void)
import Data.Text (Text)
import qualified Data.Text as Text
import Data.Word (Word32)
import Foreign.C.Types (CInt)
import Foreign.Ptr (Ptr)
import GHC.Core.Opt.Monad (CoreToDo (..))
import GHC.Data.Bag (bagToList, filterBag)
import GHC.Data.StringBuffer (stringToStringBuffer)
import GHC.Driver.Pipeline (compileOne')
import GHC.Driver.Plugins (Plugin (..), PluginWithArgs (..), StaticPlugin (..), defaultPlugin)
import GHC.Driver.Session (DynFlags (..), SafeHaskellMode (..), xopt_set)
import GHC.Driver.Types
import GHC.Hs hiding (Warning)
import GHC.HsToCore.Binds (dsTopLHsBinds)
import GHC.HsToCore.Monad (initDs)
import GHC.LanguageExtensions.Type (Extension (ForeignFunctionInterface))
import GHC.Runtime.Linker (getHValue, unload)
import GHC.Settings.Config (cProjectVersion)
import GHC.Tc.Module (tcRnModule)
import GHC.Tc.Types (TcGblEnv (..))
import GHC.TopHandler (runMainIO)
import GHC.Types.Name (Name, getName, getOccString, nameModule_maybe)
import GHC.Types.SrcLoc
import GHC.Unit.Module (mkModuleName)
import GHCi.RemoteTypes (localRef, withForeignRef)
import Rosy.Worker.Ghc.Add
import Rosy.Worker.Ghc.Blame
import Rosy.Worker.Ghc.Complete
import Rosy.Worker.Ghc.Describe
import Rosy.Worker.Ghc.Names (leaves)
import Rosy.Worker.Ghc.Read
import Rosy.Worker.Ghc.Report
import Rosy.Worker.Ghc.Twice
import Rosy.Worker.Ghc.Types
import Rosy.Worker.Ghc.Warm
import Rosy.Worker.Place (Columns, columnsOf)
import Rosy.Worker.Problem (Declaration, Function, Place (..), Problem (severity), Severity (..), Typed, isError, problemAt, problemNowhere)
import Rosy.Worker.Raw (Outline (..), Raw (..), noOutline)
import Unsafe.Coerce (unsafeCoerce)

-- | As the worker's @ready@ says it.
compilerVersion :: Text
compilerVersion = Text.pack cProjectVersion

-- | A session that has compiled a program already. Most of what the compiler knows about the library it finds out only when it
-- is needed; what it found out before a fork, every child knows.
start :: Library -> IO Session
start library = do
  session <- warm library
  _ <- analyse Guarded ToKnow session practice
  practised <- analyse Guarded ToRun session practice
  case ready practised of
    Just sample -> do
      _ <- load session sample
      -- The linker keeps what it has linked by name: without this every program's main would be the practice's.
      unload (environment session) []
    Nothing -> pure ()
  _ <- analyse Guarded ToKnow session "hole = _ :: Velocity\nwrong = not hole + \"\" + undefinedName\n"
  _ <- complete session "asked :: Velocity -> Memory Bool -> Velocity\nasked v (Memory m) = \nmain = simulate asked\n" (Place 2 22)
  pure session

-- | A program that touches most of the library.
practice :: Text
practice =
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
      "main = if length (show Go) > 3 then simulate (accelerate, play, hits, walk) else simulate square"
    ]

-- | What is known about a program after reading it and checking its types.
data Analysis = Analysis
  { -- | Rosy's own findings: what may not be imported, no @main@.
    refusals :: [Problem],
    -- | The compiler's findings.
    messages :: [Raw],
    outline :: Outline,
    declared :: [Declaration],
    connected :: [Function],
    typed :: [Typed],
    -- | Present when nothing stands in the way of a run.
    ready :: Maybe Ready
  }

-- | A program that has passed the type checker.
data Ready = Ready HscEnv ModSummary TcGblEnv Name

-- | What for: to say what is wrong and of what types things are, or to run it. Knowing is quicker.
data Aim = ToKnow | ToRun
  deriving (Eq)

-- | Reads and checks a program.
analyse :: Guard -> Aim -> Session -> Text -> IO Analysis
analyse guarded aim session source = do
  options <- optionsOf guarded (allowing (hsc_dflags (environment session))) columns source buffer
  case options of
    Left found -> pure (stopped found [])
    Right flags -> case readProgram flags columns buffer of
      Left raws -> pure (stopped [] raws)
      Right (L at parsed, warnings) -> do
        let listed = if guarded == Guarded then refusalsIn columns source parsed else []
        unsafe <- if guarded == Unguarded || not (null listed) then pure [] else unsafeImports (environment session) {hsc_dflags = flags} columns parsed
        let refused = listed ++ unsafe
        if null refused
          then check aim session flags columns source (L at parsed) warnings
          else pure (stopped refused warnings)
  where
    columns = columnsOf source
    buffer = stringToStringBuffer (Text.unpack source)
    allowing flags
      | guarded /= Unguarded = flags
      | otherwise = (xopt_set flags ForeignFunctionInterface) {safeHaskell = Sf_None, staticPlugins = [StaticPlugin (PluginWithArgs withoutStubs [])]}
    stopped found raws = Analysis found raws (noOutline source) [] [] [] Nothing

-- | For the tests of the other protections: a program that calls foreign functions is linked without the C file that the
-- compiler would write for it, and could not, so that the calls are made and the other protections have something to stop.
withoutStubs :: Plugin
withoutStubs = defaultPlugin {installCoreToDos = \_ passes -> pure (CoreDoPluginPass "without stubs" (\guts -> pure guts {mg_foreign = NoStubs}) : passes)}

-- * Checking

check :: Aim -> Session -> DynFlags -> Columns -> Text -> Located HsModule -> [Raw] -> IO Analysis
check aim session flags columns source (L at parsed) warnings = do
  let added = addRosy instances (linesWith (map Text.pack namingWords) source) (broughtWith flags (brought session)) parsed
      env = (environment session) {hsc_dflags = flags}
      summary = summaryOf flags source
      placed = definitionSpans (placeOf columns) parsed
      outlined = Outline source placed (signatureSpans (placeOf columns) parsed) [] []
  ((warned, failed), outcome) <- tcRnModule env summary False (parsedModule (L at (program added)))
  let found = warnings ++ map (fromMessage flags columns) (bagToList failed ++ bagToList warned)
      bad = any ((== Error) . gravity)
      mains = [() | ("main", _) <- placed]
      twice = [(problemAt s "second-simulate" "A program simulates once, and this is the second time." "Put all functions into one: simulate (f, g); tasks follow one another in a do.") {severity = Warning} | Just s <- [secondSimulate parsed >>= placeOf columns]]
      noMain = [problemNowhere "no-main" "The program does not say what the robot should do." "Add a line that starts with: main = simulate" | null mains]
      whole raws tcg next =
        let describe spelling = describeFunctions flags spelling (map Text.pack (concatMap leaves (controllers added))) tcg
            connections = describe AsWritten
            known = outlined {connectedTo = connections, spelledOut = describe SpelledOut}
         in Analysis (noMain ++ twice) raws known (describeDeclarations flags placed tcg) connections (typesAt (showType flags) (placeOf columns) (derivedPlaces parsed) tcg) next
  case outcome of
    Nothing -> pure (Analysis noMain found outlined [] [] [] Nothing)
    Just tcg
      | bad found -> pure (whole found tcg Nothing)
      | otherwise -> do
        -- The compiler finds missing cases only now. What it derives has none.
        ((doubts, failures), _) <- initDs env tcg (dsTopLHsBinds (filterBag (isWritten . getLoc) (tcg_binds tcg)))
        let raws = found ++ map (fromMessage flags columns) (bagToList failures ++ bagToList doubts)
        pure $
          if bad raws || any isError noMain || aim == ToKnow
            then whole raws tcg Nothing
            else whole raws tcg (Ready env summary tcg <$> mainOf tcg)
  where
    -- A program that speaks of Generic may want the real thing.
    instances = if aim == ToKnow && not ("Generic" `Text.isInfixOf` source) then Promised else Whole
    isWritten = not . standsIn (derivedPlaces parsed)
    mainOf tcg = case [getName i | i <- typeEnvIds (tcg_type_env tcg), getOccString i == "main", nameModule_maybe (getName i) == Just (tcg_mod tcg)] of
      n : _ -> Just n
      [] -> Nothing

-- * Running

-- | Compiles a checked program to bytecode in this process and gives the action that runs it: over a link's
-- descriptor, with a page for the name of the function at work.
load :: Session -> Ready -> IO (CInt -> Ptr Word32 -> IO ())
load session (Ready env plain checked name) = do
  let flags = ms_hspp_opts plain
      summary = plain {ms_hspp_opts = flags {staticPlugins = blaming : staticPlugins flags}}
  compiled <- compileOne' (Just checked) Nothing env summary 1 1 Nothing Nothing SourceModified
  let home = env {hsc_HPT = addToHpt (hsc_HPT env) (mkModuleName "Main") compiled}
  value <- getHValue home name
  -- The type checker has made sure that main is an IO action.
  action <- withForeignRef value localRef
  pure (\fd page -> launcher session fd page (void (unsafeCoerce action :: IO ())))

-- | Runs an action as a program's main thread, the one that is told when the heap is full.
asMain :: IO () -> IO ()
asMain = runMainIO
