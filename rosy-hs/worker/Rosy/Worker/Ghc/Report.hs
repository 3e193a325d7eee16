{-# LANGUAGE GADTs #-}
{-# LANGUAGE RankNTypes #-}
{-# LANGUAGE ScopedTypeVariables #-}

-- |
-- Module      : Rosy.Worker.Ghc.Report
-- Description : The compiler's messages, taken apart into our own nouns.
--
-- Keeps the parts that GHC keeps apart (what is wrong, context, further help) and the flag that a warning
-- hangs on. No judgement: that is "Rosy.Worker.Kind".
module Rosy.Worker.Ghc.Report
  ( placeOf,
    fromMessage,
    fromParser,
    showPart,
  )
where

import Data.Text (Text)
import qualified Data.Text as Text
import GHC.Driver.Flags (WarnReason (..), WarningFlag (..))
import GHC.Driver.Session (DynFlags)
import GHC.Types.SrcLoc
import GHC.Utils.Error (ErrDoc (..), ErrMsg (..), MsgDoc, errMsgSpan)
import GHC.Utils.Outputable (neverQualify, showSDocForUser)
import Rosy.Worker.Place (Columns, spanOf)
import Rosy.Worker.Problem (Severity (..), Span)
import Rosy.Worker.Raw (Raw (..), Reason (..))

placeOf :: Columns -> SrcSpan -> Maybe Span
placeOf columns s = case s of
  RealSrcSpan r _ -> Just (spanOf columns (srcSpanStartLine r, srcSpanStartCol r) (srcSpanEndLine r, srcSpanEndCol r))
  UnhelpfulSpan _ -> Nothing

-- | An error or warning of the type checker. What was put off (see "Rosy.Worker.Ghc.Warm") is an error again.
fromMessage :: DynFlags -> Columns -> ErrMsg -> Raw
fromMessage flags columns e =
  Raw
    { reason = why,
      gravity = grave,
      region = placeOf columns (errMsgSpan e),
      important = parts errDocImportant,
      context = parts errDocContext,
      supplementary = parts errDocSupplementary
    }
  where
    parts f = map (showPart flags) (f (errMsgDoc e))
    (why, grave) = weigh (errMsgReason e)

-- | A message of the parser.
fromParser :: DynFlags -> Columns -> ErrMsg -> Raw
fromParser flags columns e = (fromMessage flags columns e) {reason = why, gravity = grave}
  where
    (why, grave) = case errMsgReason e of
      Reason Opt_WarnTabs -> (Tabs, Warning)
      NoReason -> (Syntax, Error)
      _ -> (Other, Warning)

weigh :: WarnReason -> (Reason, Severity)
weigh r = case r of
  Reason Opt_WarnDeferredTypeErrors -> (Types, Error)
  Reason Opt_WarnTypedHoles -> (Hole, Error)
  Reason Opt_WarnDeferredOutOfScopeVariables -> (Scope, Error)
  Reason Opt_WarnIncompletePatterns -> (IncompletePatterns, Warning)
  Reason Opt_WarnIncompleteUniPatterns -> (IncompletePatterns, Warning)
  Reason Opt_WarnOverlappingPatterns -> (OverlappingPatterns, Warning)
  Reason Opt_WarnTabs -> (Tabs, Warning)
  Reason Opt_WarnMissingFields -> (MissingFields, Error)
  Reason Opt_WarnMissingMethods -> (MissingMethods, Warning)
  Reason _ -> (Other, Warning)
  _ -> (Types, Error)

showPart :: DynFlags -> MsgDoc -> Text
showPart flags = Text.strip . Text.pack . showSDocForUser flags neverQualify
