{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Refusals
-- Description : Sentences about modules, names and extensions that a program may not use.
--
-- Two sentences for each refusal: message and hint. Pure.
module Rosy.Worker.Refusals
  ( refuseModule,
    refuseName,
    refusedNames,
    refuseExtension,
    refuseUnknown,
    refuseOptions,
  )
where

import Data.Maybe (fromMaybe, listToMaybe)
import qualified Data.Set as Set
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.Allowlist (allowedModules)
import Rosy.Worker.Sentence

-- | Two sentences for a module that may not be imported.
refuseModule :: Text -> (Sentence, Sentence)
refuseModule m
  | any (`Text.isPrefixOf` m) ["System.IO.Unsafe", "Unsafe.", "GHC.", "Foreign", "Data.Dynamic", "System.Mem"] =
    (cannot, tr "It can get around Haskell's checks, and a robot program never needs that.")
  | m == "Debug.Trace" = (cannot, tr "To show a value while the program runs, send it with Say.")
  | any (`Text.isPrefixOf` m) ["Network", "System.Process", "System.Directory", "System.Environment", "System.Posix", "System.IO", "System.Exit", "System.Cmd"] =
    (cannot, tr "A robot program talks to its robot only: not to files, other programs or the network.")
  | any (`Text.isPrefixOf` m) ["Control.Concurrent", "Control.Parallel", "Control.Monad.STM"] =
    (cannot, tr "Functions in a list or a tuple already run side by side; share values between them with Memory.")
  | m `elem` ["Data.IORef", "Data.STRef", "Control.Monad.ST", "Control.Monad.State", "Data.Array.IO", "Data.Array.ST"] =
    (cannot, tr "To remember something from one firing to the next, use Memory.")
  | any (`Text.isPrefixOf` m) ["Data.Time", "System.CPUTime", "System.Clock"] =
    (cannot, tr "To know the time, let a function take Seconds or Clock.")
  | any (`Text.isPrefixOf` m) ["Language.Haskell", "Data.Data"] =
    (cannot, tr "Programs that write programs are not possible here.")
  | "Control.Exception" `Text.isPrefixOf` m =
    (cannot, tr "Let a function give a Maybe or an Either when something may go wrong.")
  | Text.toLower m `elem` map Text.toLower (Set.toList allowedModules) =
    (trWith "There is no module ‘{module}’." ["module" =: m], trWith "Did you mean ‘{module}’? Capital letters count." ["module" =: right])
  | otherwise =
    (trWith "The module ‘{module}’ is not available here." ["module" =: m], tr "Programs can use Rosy, the usual parts of base, containers and System.Random.")
  where
    cannot = trWith "A program cannot import ‘{module}’." ["module" =: m]
    right = fromMaybe m (listToMaybe [a | a <- Set.toList allowedModules, Text.toLower a == Text.toLower m])

refusedNames, fileNames, inputNames :: [Text]
refusedNames = fileNames ++ inputNames
fileNames = ["readFile", "writeFile", "appendFile"]
inputNames = ["getLine", "getChar", "getContents", "interact", "readLn", "readIO"]

-- | Two sentences for a Prelude function with access to files or input.
refuseName :: Text -> Maybe (Sentence, Sentence)
refuseName n
  | n `elem` fileNames = Just (cannot, tr "A robot program talks to its robot only, not to files.")
  | n `elem` inputNames = Just (cannot, tr "Nothing can be typed while the robot drives: let a function take a Button.")
  | otherwise = Nothing
  where
    cannot = trWith "A program cannot use ‘{name}’." ["name" =: n]

refuseExtension :: Text -> (Sentence, Sentence)
refuseExtension e
  | e `elem` ["TemplateHaskell", "TemplateHaskellQuotes", "QuasiQuotes"] =
    (cannot, tr "Programs that write programs are not possible here.")
  | e `elem` ["CPP", "ForeignFunctionInterface", "CApiFFI", "InterruptibleFFI", "UnliftedFFITypes", "JavaScriptFFI"] =
    (cannot, tr "A robot program is all Haskell: it cannot reach other languages.")
  | otherwise =
    (cannot, tr "Remove it: the usual extensions are switched on already.")
  where
    cannot = trWith "A program cannot switch on ‘{extension}’." ["extension" =: e]

-- | For an extension unknown to GHC; empty if the whole line was not understood.
refuseUnknown :: Text -> (Sentence, Sentence)
refuseUnknown e
  | Text.null e = (tr "This line at the top of the program is not understood.", tr "Remove it: the usual extensions are switched on already.")
  | otherwise = (trWith "There is no extension called ‘{extension}’." ["extension" =: e], tr "Remove it: the usual extensions are switched on already.")

refuseOptions :: (Sentence, Sentence)
refuseOptions = (tr "A program cannot give options to the compiler.", tr "Remove the line with OPTIONS_GHC.")
