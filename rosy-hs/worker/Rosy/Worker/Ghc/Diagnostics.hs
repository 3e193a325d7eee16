{-# LANGUAGE GADTs #-}
{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE RankNTypes #-}
{-# LANGUAGE ScopedTypeVariables #-}

-- |
-- Module      : Rosy.Worker.Ghc.Diagnostics
-- Description : Conversion of GHC's diagnostics to compiler messages.
--
-- Keeps the parts of GHC's messages (error, context, hints) and classifies them by warning flag and diagnostic. Explanations
-- are written by "Rosy.Worker.Explanation".
module Rosy.Worker.Ghc.Diagnostics
  ( spanAt,
    fromTypeChecker,
    fromParser,
  )
where

import Data.Text (Text)
import qualified Data.Text as Text
import GHC.Driver.Session (DynFlags)
import GHC.Types.SrcLoc
import Rosy.Worker.CompilerMessage (Category (..), CompilerMessage (CompilerMessage))
import qualified Rosy.Worker.CompilerMessage as Message
import Rosy.Worker.Ghc.Compat.Driver (CompilerDiagnostic)
import Rosy.Worker.Ghc.Compat.Messages
import Rosy.Worker.Problem (Severity (..), Span)
import Rosy.Worker.TabStops (TabStops, spanFromGhc)

spanAt :: TabStops -> SrcSpan -> Maybe Span
spanAt columns s = case s of
  RealSrcSpan r _ -> Just (spanFromGhc columns (srcSpanStartLine r, srcSpanStartCol r) (srcSpanEndLine r, srcSpanEndCol r))
  UnhelpfulSpan _ -> Nothing

-- | An error or warning of the type checker. Deferred errors (see "Rosy.Worker.Ghc.Session") are errors again.
fromTypeChecker :: DynFlags -> TabStops -> CompilerDiagnostic -> CompilerMessage
fromTypeChecker = convert typeErrorCategory

-- | An error or warning of the parser.
fromParser :: DynFlags -> TabStops -> CompilerDiagnostic -> CompilerMessage
fromParser = convert (maybe (Syntax, Error) (\f -> if f == Opt_WarnTabs then (Tabs, Warning) else (Other, Warning)))

convert :: (Maybe WarningFlag -> (Category, Severity)) -> DynFlags -> TabStops -> CompilerDiagnostic -> CompilerMessage
convert classified flags columns diagnostic =
  CompilerMessage
    { Message.category = what,
      Message.messageCode = codeNumber parts,
      Message.finding = statedFinding parts,
      Message.messageSeverity = severe,
      Message.messageSpan = spanAt columns (messageAt parts),
      Message.important = texts errorPart,
      Message.context = texts contextPart,
      Message.supplementary = texts hintPart
    }
  where
    parts = messageParts flags diagnostic
    texts part = map (classicWording . Text.strip . Text.pack) (part parts)
    (what, severe) = classified (warningFlag parts)

typeErrorCategory :: Maybe WarningFlag -> (Category, Severity)
typeErrorCategory flag = case flag of
  Just Opt_WarnDeferredTypeErrors -> (Types, Error)
  Just Opt_WarnTypedHoles -> (Hole, Warning)
  Just Opt_WarnDeferredOutOfScopeVariables -> (Scope, Error)
  Just Opt_WarnIncompletePatterns -> (IncompletePatterns, Warning)
  Just Opt_WarnIncompleteUniPatterns -> (IncompletePatterns, Warning)
  Just Opt_WarnOverlappingPatterns -> (OverlappingPatterns, Warning)
  Just Opt_WarnTabs -> (Tabs, Warning)
  Just Opt_WarnMissingFields -> (MissingFields, Error)
  Just Opt_WarnMissingMethods -> (MissingMethods, Warning)
  Just _ -> (Other, Warning)
  Nothing -> (Types, Error)

-- | Sentences of GHC 9.4 and newer in the wording of GHC 9.0, which "Rosy.Worker.Explanation" reads. Identity on messages of GHC 9.0.
classicWording :: Text -> Text
classicWording = instances . Text.unlines . map line . Text.lines . Text.replace "Perhaps use " "Perhaps you meant " . Text.replace " visible argument" " value argument"
  where
    line l
      | (before, rest) <- Text.breakOn "Patterns of type \8216" l, not (Text.null rest), (_, after) <- Text.breakOn "not matched:" rest, not (Text.null after) = before <> "Patterns " <> after
      | otherwise = l
    instances t = case Text.breakOn "No instance for \8216" t of
      (before, rest)
        | Text.null rest -> Text.stripEnd t
        | (inside, after) <- Text.breakOn "\8217" (Text.drop 17 rest) -> before <> "No instance for (" <> inside <> ")" <> instances (Text.drop 1 after)
