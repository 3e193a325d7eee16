{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Allowlist
-- Description : Allowlists of modules and language extensions.
--
-- A module is listed if everything it exports is pure or harmless. "Rosy.Worker.Refusals" has the sentences about all others. Pure.
module Rosy.Worker.Allowlist
  ( -- * Modules
    isAllowedModule,
    allowedModules,

    -- * Extensions
    isAllowedExtension,
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

isAllowedExtension :: Text -> Bool
isAllowedExtension e = base `Set.member` allowedExtensions
  where
    base = fromMaybe e (Text.stripPrefix "No" e)

-- | Extensions of syntax and types. Excluded: everything that runs code at compile time, calls foreign code, or weakens type safety.
allowedExtensions :: Set.Set Text
allowedExtensions =
  Set.fromList . concatMap Text.words $
    [ "Haskell2010 Haskell98 Safe",
      "ApplicativeDo Arrows BangPatterns BinaryLiterals BlockArguments ConstrainedClassMethods ConstraintKinds DataKinds",
      "DefaultSignatures DeriveAnyClass DeriveFoldable DeriveFunctor DeriveGeneric DeriveTraversable DerivingStrategies DerivingVia",
      "DisambiguateRecordFields DuplicateRecordFields EmptyCase EmptyDataDecls EmptyDataDeriving ExistentialQuantification",
      "ExplicitForAll ExplicitNamespaces FlexibleContexts FlexibleInstances FunctionalDependencies GADTSyntax GADTs GeneralisedNewtypeDeriving GeneralizedNewtypeDeriving",
      "HexFloatLiterals ImplicitPrelude InstanceSigs KindSignatures LambdaCase MonadComprehensions",
      "MonoLocalBinds MonomorphismRestriction MultiParamTypeClasses MultiWayIf NamedFieldPuns NamedWildCards",
      "NegativeLiterals NumericUnderscores OverloadedStrings ParallelListComp PartialTypeSignatures",
      "PatternGuards PatternSynonyms PolyKinds PostfixOperators RankNTypes RecordWildCards",
      "RecursiveDo RoleAnnotations ScopedTypeVariables StandaloneDeriving StandaloneKindSignatures StarIsType Strict",
      "StrictData TraditionalRecordSyntax TupleSections TypeApplications TypeFamilies TypeOperators",
      "TypeSynonymInstances UnicodeSyntax ViewPatterns"
    ]
