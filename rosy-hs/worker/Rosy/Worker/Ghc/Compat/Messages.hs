{-# LANGUAGE CPP #-}
{-# LANGUAGE PatternSynonyms #-}
{-# LANGUAGE TypeApplications #-}
-- Which module exports a name differs between versions.
{-# OPTIONS_GHC -Wno-unused-imports #-}

-- |
-- Module      : Rosy.Worker.Ghc.Compat.Messages
-- Description : Compatibility layer over GHC's diagnostics, for GHC 9.0, 9.4, 9.6 and newer.
--
-- Splits a diagnostic into error, context and hints, which GHC 9.0 keeps as one document and later versions as data, and reads its
-- warning flag. With GHC 9.6 and newer also its code, and as a finding what its constructor holds.
module Rosy.Worker.Ghc.Compat.Messages
  ( MessageParts (..),
    messageParts,
    WarningFlag (..),
  )
where

{- HLINT ignore "Unused LANGUAGE pragma" -}

import Data.Text (Text)
import qualified Data.Text as Text
import GHC.Driver.Flags
import GHC.Driver.Session (DynFlags)
import GHC.Types.SrcLoc (SrcSpan)
import GHC.Utils.Outputable (SDoc)
import Rosy.Worker.CompilerMessage (Finding (..))
import Rosy.Worker.Ghc.Compat.Driver (CompilerDiagnostic)
import Rosy.Worker.Ghc.Compat.Types (renderForUser)
#if __GLASGOW_HASKELL__ >= 904
import GHC.Driver.Errors.Types
import GHC.Tc.Errors.Types
import GHC.Types.Error
import GHC.Utils.Outputable (Outputable, ppr)
#else
import GHC.Utils.Error
#endif
#if __GLASGOW_HASKELL__ >= 906
import GHC.Core.TyCo.FVs (tyCoVarsOfTypeList)
import GHC.LanguageExtensions.Type (Extension (DataKinds))
import GHC.Tc.Types.Constraint (ctLocOrigin)
import GHC.Tc.Types.Origin (CtOrigin (..))
import GHC.Tc.Utils.TcType (isAmbiguousTyVar)
import GHC.Types.Hint (GhcHint (..), LanguageExtensionHint (..))
import GHC.Types.Name (nameOccName)
#endif
#if __GLASGOW_HASKELL__ >= 910
import qualified Data.List.NonEmpty as NonEmpty
#endif

data MessageParts = MessageParts
  { messageAt :: SrcSpan,
    -- | Present for warnings, which include deferred errors.
    warningFlag :: Maybe WarningFlag,
    -- | The number of GHC's code, from GHC 9.6 on.
    codeNumber :: Maybe Int,
    -- | What GHC states as data, from GHC 9.6 on.
    statedFinding :: Maybe Finding,
    errorPart :: [String],
    contextPart :: [String],
    hintPart :: [String]
  }

messageParts :: DynFlags -> CompilerDiagnostic -> MessageParts
#if __GLASGOW_HASKELL__ >= 904
messageParts flags m =
  MessageParts
    { messageAt = errMsgSpan m,
      warningFlag = flag,
      codeNumber = number (errMsgDiagnostic m),
      statedFinding = findingIn flags detailed,
      errorPart = rendered (documents inner),
      contextPart = rendered context,
      hintPart = rendered (supplementary ++ map ppr (diagnosticHints (errMsgDiagnostic m)))
    }
  where
    rendered = map (renderForUser flags)
    (inner, context, supplementary) = case errMsgDiagnostic m of
      GhcTcRnMessage (TcRnMessageWithInfo _ (TcRnMessageDetailed info detail)) -> (GhcTcRnMessage detail, [errInfoContext info], [errInfoSupplementary info])
      other -> (other, [], [])
    detailed = case inner of
      GhcTcRnMessage detail -> Just detail
      _ -> Nothing
#if __GLASGOW_HASKELL__ >= 906
    documents = unDecorated . diagnosticMessage (defaultDiagnosticOpts' :: DiagnosticOpts GhcMessage)
    number = fmap (fromIntegral . diagnosticCodeNumber) . diagnosticCode
#else
    documents = unDecorated . diagnosticMessage
    number _ = Nothing
#endif
#if __GLASGOW_HASKELL__ >= 910
    flag = case resolvedDiagnosticReason (errMsgReason m) of
      WarningWithFlags fs -> Just (NonEmpty.head fs)
      _ -> Nothing
    defaultDiagnosticOpts' = defaultDiagnosticOpts @GhcMessage
#else
    flag = case diagnosticReason (errMsgDiagnostic m) of
      WarningWithFlag f -> Just f
      _ -> Nothing
#if __GLASGOW_HASKELL__ >= 906
    defaultDiagnosticOpts' = defaultDiagnosticOpts @GhcMessage
#endif
#endif
#else
messageParts flags m =
  MessageParts
    { messageAt = errMsgSpan m,
      warningFlag = case errMsgReason m of
        Reason f -> Just f
        _ -> Nothing,
      codeNumber = Nothing,
      statedFinding = Nothing,
      errorPart = parts errDocImportant,
      contextPart = parts errDocContext,
      hintPart = parts errDocSupplementary
    }
  where
    parts field = map (renderForUser flags) (field (errMsgDoc m))
#endif

#if __GLASGOW_HASKELL__ >= 906
pattern SolverError :: TcSolverReportMsg -> TcRnMessage
pattern UnknownName :: [ImportError] -> HoleError
#if __GLASGOW_HASKELL__ >= 910
pattern SolverError report <- TcRnSolverReport (SolverReportWithCtxt _ report) _
pattern UnknownName importErrors <- OutOfScopeHole importErrors _
#else
pattern SolverError report <- TcRnSolverReport (SolverReportWithCtxt _ report) _ _
pattern UnknownName importErrors <- OutOfScopeHole importErrors
#endif

-- | Reads the constructors of GHC's type checker messages.
findingIn :: DynFlags -> Maybe TcRnMessage -> Maybe Finding
findingIn flags message = case message of
  Just (SolverError report) -> case report of
    Mismatch {mismatchMsg = m} -> difference m
    CannotUnifyVariable {mismatchMsg = m} -> difference m
    CannotResolveInstance {cannotResolve_item = item, cannotResolve_unifiers = unifiers, cannotResolve_candidates = candidates} ->
      let constraint = text (ei_pred item)
          unknown = filter isAmbiguousTyVar (tyCoVarsOfTypeList (ei_pred item))
       in Just $ case unknown of
            v : _ | not (null unifiers), null candidates -> VariableAmbiguous (text v) constraint (userOf item)
            _ -> InstanceMissing constraint (userOf item)
    ReportHoleError _ (UnknownName importErrors) -> moduleMissing importErrors
    _ -> Nothing
  Just (TcRnNotInScope _ _ importErrors hints)
    | any isDataKinds hints -> Just ConstructorAsType
    | otherwise -> moduleMissing importErrors
  _ -> Nothing
  where
    text :: Outputable a => a -> Text
    text = Text.pack . renderForUser flags . ppr
    difference m = case m of
      BasicMismatch {mismatch_ea = EA (Just (ExpectedActual expected actual))} -> Just (TypesDiffer (text expected) (text actual))
      BasicMismatch {mismatch_ty1 = expected, mismatch_ty2 = actual} -> Just (TypesDiffer (text expected) (text actual))
      TypeEqMismatch {teq_mismatch_expected = expected, teq_mismatch_actual = actual} -> Just (TypesDiffer (text expected) (text actual))
      _ -> Nothing
    userOf item = case ctLocOrigin (ei_loc item) of
      OccurrenceOf name -> Just (text (nameOccName name))
      LiteralOrigin literal -> Just (text literal)
      _ -> Nothing
    moduleMissing errors = case [m | MissingModule m <- errors] of
      m : _ -> Just (ModuleNotImported (text m))
      [] -> Nothing
    isDataKinds hint = case hint of
      SuggestExtension (SuggestSingleExtension _ DataKinds) -> True
      _ -> False
#else
findingIn :: DynFlags -> Maybe message -> Maybe Finding
findingIn _ _ = Nothing
#endif
