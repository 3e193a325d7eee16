{-# LANGUAGE CPP #-}
{-# LANGUAGE TypeApplications #-}
-- Which module exports a name differs between versions.
{-# OPTIONS_GHC -Wno-unused-imports #-}

-- |
-- Module      : Rosy.Worker.Ghc.Compat.Messages
-- Description : Compatibility layer over GHC's diagnostics, for GHC 9.0, 9.4, 9.6 and newer.
--
-- Splits a diagnostic into error, context and hints, which GHC 9.0 keeps as one document and later versions as data, and reads its
-- warning flag and its code (GHC 9.6 and newer).
module Rosy.Worker.Ghc.Compat.Messages
  ( MessageParts (..),
    messageParts,
    WarningFlag (..),
  )
where

{- HLINT ignore "Unused LANGUAGE pragma" -}

import GHC.Driver.Flags
import GHC.Driver.Session (DynFlags)
import GHC.Types.SrcLoc (SrcSpan)
import GHC.Utils.Outputable (SDoc)
import Rosy.Worker.Ghc.Compat.Driver (CompilerDiagnostic)
import Rosy.Worker.Ghc.Compat.Types (renderForUser)
#if __GLASGOW_HASKELL__ >= 904
import GHC.Driver.Errors.Types
import GHC.Tc.Errors.Types
import GHC.Types.Error
import GHC.Utils.Outputable (ppr)
#else
import GHC.Utils.Error
#endif
#if __GLASGOW_HASKELL__ >= 910
import qualified Data.List.NonEmpty as NonEmpty
#endif

data MessageParts = MessageParts
  { messageAt :: SrcSpan,
    -- | Present for warnings, which include deferred errors.
    warningFlag :: Maybe WarningFlag,
    -- | The number of GHC's code, from GHC 9.6 on.
    code :: Maybe Int,
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
      code = number (errMsgDiagnostic m),
      errorPart = rendered (documents inner),
      contextPart = rendered context,
      hintPart = rendered (supplementary ++ map ppr (diagnosticHints (errMsgDiagnostic m)))
    }
  where
    rendered = map (renderForUser flags)
    (inner, context, supplementary) = case errMsgDiagnostic m of
      GhcTcRnMessage (TcRnMessageWithInfo _ (TcRnMessageDetailed info detail)) -> (GhcTcRnMessage detail, [errInfoContext info], [errInfoSupplementary info])
      other -> (other, [], [])
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
      code = Nothing,
      errorPart = parts errDocImportant,
      contextPart = parts errDocContext,
      hintPart = parts errDocSupplementary
    }
  where
    parts field = map (renderForUser flags) (field (errMsgDoc m))
#endif
