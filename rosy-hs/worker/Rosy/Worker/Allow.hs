{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Allow
-- Description : What a program may import and which extensions it may ask for.
--
-- The lists, and a sentence for everything that is not on them. A module stands here when every function it
-- exports is pure or harmless; nothing is allowed because it is not forbidden. Pure.
module Rosy.Worker.Allow
  ( -- * Modules
    isAllowedModule,
    allowedModules,
    refuseModule,
    refuseName,
    refusedNames,

    -- * Extensions
    isAllowedExtension,
    refuseExtension,
    refuseUnknown,
    refuseOptions,
  )
where

import Data.Maybe (fromMaybe)
import qualified Data.Set as Set
import Data.Text (Text)
import qualified Data.Text as Text

isAllowedModule :: Text -> Bool
isAllowedModule m = m `Set.member` allowedModules

-- | base's pure modules that are commonly taught, containers, random, and Rosy.
allowedModules :: Set.Set Text
allowedModules =
  Set.fromList . concatMap Text.words $
    [ "Rosy Prelude",
      "Data.Bits Data.Bool Data.Char Data.Coerce Data.Complex Data.Either Data.Eq Data.Fixed Data.Foldable Data.Function",
      "Data.Functor Data.Functor.Classes Data.Functor.Compose Data.Functor.Const Data.Functor.Identity Data.Functor.Product",
      "Data.Functor.Sum Data.Int Data.Ix Data.Kind Data.List Data.List.NonEmpty Data.Maybe Data.Monoid Data.Ord Data.Proxy",
      "Data.Ratio Data.Semigroup Data.String Data.Traversable Data.Tuple Data.Void Data.Word Data.Bifunctor Data.Bifoldable",
      "Data.Bitraversable Data.Typeable Control.Applicative Control.Arrow Control.Category Control.Monad Control.Monad.Fail",
      "Control.Monad.Fix Control.Monad.Zip Numeric Numeric.Natural GHC.Generics Text.Read Text.Show Text.Printf",
      "Data.Map Data.Map.Strict Data.Map.Lazy Data.Set Data.IntMap Data.IntMap.Strict Data.IntMap.Lazy Data.IntSet",
      "Data.Sequence Data.Tree Data.Graph System.Random"
    ]

-- | Two sentences for a module that may not be imported.
refuseModule :: Text -> (Text, Text)
refuseModule m
  | any (`Text.isPrefixOf` m) ["System.IO.Unsafe", "Unsafe.", "GHC.", "Foreign", "Data.Dynamic", "System.Mem"] =
    (cannot, "It can go behind Haskell's back, and a robot program never needs that.")
  | m == "Debug.Trace" = (cannot, "To show a value while the program runs, send it with Say.")
  | any (`Text.isPrefixOf` m) ["Network", "System.Process", "System.Directory", "System.Environment", "System.Posix", "System.IO", "System.Exit", "System.Cmd"] =
    (cannot, "A robot program talks to its robot only: not to files, other programs or the network.")
  | any (`Text.isPrefixOf` m) ["Control.Concurrent", "Control.Parallel", "Control.Monad.STM"] =
    (cannot, "Functions in a list or a tuple already run side by side; share values between them with Memory.")
  | m `elem` ["Data.IORef", "Data.STRef", "Control.Monad.ST", "Control.Monad.State", "Data.Array.IO", "Data.Array.ST"] =
    (cannot, "To remember something from one firing to the next, use Memory.")
  | any (`Text.isPrefixOf` m) ["Data.Time", "System.CPUTime", "System.Clock"] =
    (cannot, "To know the time, let a function take Seconds or Clock.")
  | any (`Text.isPrefixOf` m) ["Language.Haskell", "Data.Data"] =
    (cannot, "Programs that write programs are not possible here.")
  | "Control.Exception" `Text.isPrefixOf` m =
    (cannot, "Let a function give a Maybe or an Either when something may go wrong.")
  | Text.toLower m `elem` map Text.toLower (Set.toList allowedModules) =
    ("There is no module " <> quoted m <> ".", "Did you mean " <> quoted right <> "? Capital letters count.")
  | otherwise =
    ("The module " <> quoted m <> " is not available here.", "Programs can use Rosy, the usual parts of base, containers and System.Random.")
  where
    cannot = "A program cannot import " <> quoted m <> "."
    right = head ([a | a <- Set.toList allowedModules, Text.toLower a == Text.toLower m] ++ [m])

refusedNames, fileNames, inputNames :: [Text]
refusedNames = fileNames ++ inputNames
fileNames = ["readFile", "writeFile", "appendFile"]
inputNames = ["getLine", "getChar", "getContents", "interact", "readLn", "readIO"]

-- | Two sentences for a function of the Prelude that reaches out of the program.
refuseName :: Text -> Maybe (Text, Text)
refuseName n
  | n `elem` fileNames = Just (cannot, "A robot program talks to its robot only, not to files.")
  | n `elem` inputNames = Just (cannot, "Nobody types while the robot drives: let a function take a Button.")
  | otherwise = Nothing
  where
    cannot = "A program cannot use " <> quoted n <> "."

quoted :: Text -> Text
quoted t = "‘" <> t <> "’"

isAllowedExtension :: Text -> Bool
isAllowedExtension e = base `Set.member` allowedExtensions
  where
    base = fromMaybe e (Text.stripPrefix "No" e)

-- | Extensions of syntax and types. Missing on purpose: everything that runs code while compiling, calls foreign code,
-- or weakens the type system's promises.
allowedExtensions :: Set.Set Text
allowedExtensions =
  Set.fromList . concatMap Text.words $
    [ "Haskell2010 Haskell98 Safe",
      "ApplicativeDo Arrows BangPatterns BinaryLiterals BlockArguments ConstrainedClassMethods ConstraintKinds DataKinds",
      "DefaultSignatures DeriveAnyClass DeriveFoldable DeriveFunctor DeriveGeneric DeriveTraversable DerivingStrategies",
      "DisambiguateRecordFields DuplicateRecordFields EmptyCase EmptyDataDecls EmptyDataDeriving ExistentialQuantification",
      "ExplicitForAll ExplicitNamespaces FlexibleContexts FlexibleInstances FunctionalDependencies GADTSyntax GADTs",
      "HexFloatLiterals ImplicitParams ImplicitPrelude InstanceSigs KindSignatures LambdaCase LiberalTypeSynonyms MonadComprehensions",
      "MonoLocalBinds MonomorphismRestriction MultiParamTypeClasses MultiWayIf NamedFieldPuns NamedWildCards",
      "NegativeLiterals NumDecimals NumericUnderscores OverloadedStrings PackageImports ParallelListComp PartialTypeSignatures",
      "PatternGuards PatternSynonyms PolyKinds PostfixOperators QuantifiedConstraints RankNTypes RecordWildCards",
      "RecursiveDo RoleAnnotations ScopedTypeVariables StandaloneDeriving StandaloneKindSignatures StarIsType Strict",
      "StrictData TraditionalRecordSyntax TransformListComp TupleSections TypeApplications TypeFamilies TypeOperators",
      "TypeSynonymInstances UnicodeSyntax ViewPatterns"
    ]

refuseExtension :: Text -> (Text, Text)
refuseExtension e
  | e `elem` ["TemplateHaskell", "TemplateHaskellQuotes", "QuasiQuotes"] =
    (cannot, "Programs that write programs are not possible here.")
  | e `elem` ["CPP", "ForeignFunctionInterface", "CApiFFI", "InterruptibleFFI", "UnliftedFFITypes", "JavaScriptFFI"] =
    (cannot, "A robot program is all Haskell: it cannot reach other languages.")
  | otherwise =
    (cannot, "Remove it: the usual extensions are switched on already.")
  where
    cannot = "A program cannot switch on " <> quoted e <> "."

-- | For an extension that the compiler has never heard of; empty when the whole line is not understood.
refuseUnknown :: Text -> (Text, Text)
refuseUnknown e
  | Text.null e = ("This line at the top of the program is not understood.", "Remove it: the usual extensions are switched on already.")
  | otherwise = ("There is no extension called " <> quoted e <> ".", "Remove it: the usual extensions are switched on already.")

refuseOptions :: (Text, Text)
refuseOptions = ("A program cannot give options to the compiler.", "Remove the line with OPTIONS_GHC.")
