{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE RecordWildCards #-}

-- |
-- Module      : Rosy.Worker.Explanation.NameErrors
-- Description : Explanations of names that are not in scope, or mean two things.
--
-- Covers values, types, signs and modules, with suggestions of similar names. Pure.
module Rosy.Worker.Explanation.NameErrors
  ( nameErrors,
    notInScope,
    ambiguousName,
    moduleErrors,
  )
where

import Control.Applicative ((<|>))
import Data.Char (isAlphaNum, isDigit)
import Data.Maybe (fromMaybe, listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.CompilerMessage
import Rosy.Worker.Explanation.ImportSuggestions (moduleExporting, moduleForAlias)
import Rosy.Worker.Explanation.MessageParts
import Rosy.Worker.Explanation.MessageText
import Rosy.Worker.Explanation.OriginalVocabulary (originalOptionsHint)
import Rosy.Worker.Explanation.QuickFixes (nearMisses)
import Rosy.Worker.Explanation.RobotVocabulary
import Rosy.Worker.Explanation.TextRepair (capitalised)
import Rosy.Worker.Explanation.TypeMessages
import Rosy.Worker.Problem
import Rosy.Worker.Sentence

-- | Rules about names that are not in scope, in their order.
nameErrors :: [Rule]
nameErrors = [notImported, undefinedThing, undefinedValue]

-- | A module is not imported.
notImported :: Rule
notImported m = moduleNotImported m <$> missingModule m

-- | The module of a qualified name, if it is not imported.
missingModule :: MessageParts -> Maybe Text
missingModule m@MessageParts {..} = case (finding raw, qualifier m) of
  (Just (ModuleNotImported q), _) -> Just q
  -- GHC 9.4 leaves out the qualifier, and that its module is not imported.
  (Nothing, Just q) | mentions "Variable not in scope", not (imports q) -> Just q
  _ -> Nothing
  where
    imports q = or [q `elem` ws | "import" : ws <- map Text.words (Text.lines (text outline))]

-- | The qualifier of the unknown name, as the program has it.
qualifier :: MessageParts -> Maybe Text
qualifier m@MessageParts {..} = Text.stripSuffix ("." <> nameAlone m) =<< snippet (text outline) =<< messageSpan raw

moduleNotImported :: MessageParts -> Text -> Problem
moduleNotImported MessageParts {..} q = problem "not-in-scope" (trWith "‘{module}’ is not imported." ["module" =: q]) (importHint q)

-- | A type or constructor is not in scope, or one of another kind.
undefinedThing :: Rule
undefinedThing m@MessageParts {..} = case after "Not in scope: " messageText of
  Just rest -> Just (undefinedIn rest)
  Nothing -> Nothing
  where
    undefinedIn rest
      | Just advice <- unitHint firstName, endsInNumber before = problem "unit" (tr "A number is written without its unit.") advice
      | finding raw == Just ConstructorAsType || "data constructor of that name" `Text.isInfixOf` Text.unwords [messageText, everything] = problem "not-a-type" (trWith "‘{name}’ is a value, not a type." ["name" =: firstName]) (fromMaybe (tr "In a type, write the type that it belongs to.") (typeOfValue firstName))
      | "type variable" `Text.isPrefixOf` rest = problem "not-in-scope" (trWith "There is no type called ‘{name}’." ["name" =: firstName]) (tr "Types begin with capital letters, for example: Turn Double")
      | any (`Text.isInfixOf` everything) ["No module named", "no module named"],
        module_ <- fromMaybe "" (listToMaybe (drop 1 names)) =
        moduleNotImported m module_
      | "type constructor or class" `Text.isPrefixOf` rest = problem "not-in-scope" (trWith "There is no type called ‘{name}’." ["name" =: firstName]) (fromMaybe (if amongValues then tr "If it is one more value of this type, write | in front of it." else nearMiss everything firstName) (foreignNameHint firstName))
      | otherwise = problem "not-in-scope" (trWith "There is nothing called ‘{name}’." ["name" =: firstName]) (fromMaybe (nearMiss everything firstName) (originalOptionsHint before <|> foreignNameHint firstName))

    -- As in: data Mode = Go Stop
    amongValues = null (nearMisses everything firstName) && "data" `elem` take 1 (Text.words (maybe "" (lineAt outline) (messageSpan raw))) && "=" `Text.isInfixOf` before

-- | A variable is not in scope.
undefinedValue :: Rule
undefinedValue m
  | mentions m "not in scope:" = Just (notInScope m)
  | otherwise = Nothing

notInScope :: MessageParts -> Problem
notInScope m@MessageParts {..}
  | Just q <- missingModule m = moduleNotImported m q
  | Just advice <- unitHint unknownName, endsInNumber before = problem "unit" (tr "A number is written without its unit.") advice
  | behindDot = problem "operator" (tr "A value has no parts after a dot.") (tr "Take it apart with a pattern, for example: (Position x y)")
  | Text.isPrefixOf "(" unknownName = problem "operator" (trWith "There is no sign ‘{sign}’." ["sign" =: sign]) (fromMaybe (nearMiss everything sign) (foreignNameHint sign))
  | otherwise = problem "not-in-scope" (trWith "There is nothing called ‘{name}’." ["name" =: unknownName]) (fromMaybe (nearMiss everything unknownName) (foreignNameHint unknownName))
  where
    unknownName = maybe (nameAlone m) (<> "." <> nameAlone m) (qualifier m)
    sign = Text.dropAround (`elem` ("()" :: String)) unknownName
    -- As in p.x: the dot touches both.
    behindDot = case Text.unsnoc before of
      Just (rest, '.') | Just (_, c) <- Text.unsnoc rest -> isAlphaNum c || c == ')'
      _ -> False

-- | The unknown name without its qualifier.
nameAlone :: MessageParts -> Text
nameAlone MessageParts {..} = Text.takeWhile (/= ' ') (fromMaybe "?" (after "not in scope: " messageText))

endsInNumber :: Text -> Bool
endsInNumber = maybe False (isDigit . snd) . Text.unsnoc . Text.stripEnd

-- | A name of two things.
ambiguousName :: Rule
ambiguousName MessageParts {..}
  | states 87543 "Ambiguous occurrence" = Just $ problem "ambiguous-name" (trWith "‘{name}’ is the name of two things." ["name" =: firstName]) (whichOne firstName everything)
  | otherwise = Nothing

-- | A module that is not available, or has no such name.
moduleErrors :: Rule
moduleErrors MessageParts {..}
  | mentions "does not export" = Just $ problem "not-in-scope" (maybe (trWith "The module ‘{module}’ has no such name." ["module" =: firstName]) (\n -> trWith "The module ‘{module}’ has no ‘{name}’." ["module" =: firstName, "name" =: n]) (listToMaybe (drop 1 names))) (tr "Check its spelling.")
  | mentions "Could not find module" || mentions "Could not load module" = Just $ problem "import" (trWith "The module ‘{module}’ is not available here." ["module" =: firstName]) (tr "Remove this import.")
  | otherwise = Nothing

-- | Suggests similar names.
nearMiss :: Text -> Text -> Sentence
nearMiss everything unknownName = case nearMisses everything unknownName of
  [] -> maybe (tr "Check its spelling, or define it.") (\m -> trWith "It comes with Haskell: write at the top: import {module} ({name})" ["module" =: m, "name" =: unknownName]) (moduleExporting unknownName)
  [x]
    | Text.toLower x == x, Text.toUpper x == unknownName, Text.length x > 1 -> trWith "Write it in small letters: {name}" ["name" =: x]
    | capitalised x == unknownName -> trWith "Write it with a small letter: {name}" ["name" =: x]
    | x == capitalised unknownName -> trWith "Write it with a capital letter: {name}" ["name" =: x]
    | Text.toLower x == Text.toLower unknownName -> trWith "Capital and small letters count: {name}" ["name" =: x]
  xs -> trWith "Did you mean {or names}?" ["names" =* take 3 xs]

-- | Hint for a name with two definitions, one of which may be in the program.
whichOne :: Text -> Text -> Sentence
whichOne name everything
  | "defined at" `Text.isInfixOf` everything = maybe (tr "Give yours another name.") (\m -> trWith "One comes from {module}: give yours another name." ["module" =: m]) (listToMaybe modules)
  | m : _ <- filter (`notElem` ["Prelude", "Rosy"]) modules = trWith "Keep what comes from {module} apart: write import qualified {module} as {alias}, and then {alias}.{name}" ["module" =: m, "alias" =: shortOf m, "name" =: name]
  | otherwise = tr "Write the module in front of it."
  where
    modules = [Text.takeWhile (/= '’') t | t <- drop 1 (Text.splitOn "imported from ‘" everything)]
    shortOf m = last (Text.splitOn "." m)

importHint :: Text -> Sentence
importHint q = case moduleForAlias q of
  Just m -> trWith "Write at the top: import qualified {module} as {alias}" ["module" =: m, "alias" =: q]
  Nothing -> tr "Import the module, or leave out what comes before the dot."
