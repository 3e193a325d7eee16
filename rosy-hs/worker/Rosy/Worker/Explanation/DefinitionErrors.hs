{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE RecordWildCards #-}

-- |
-- Module      : Rosy.Worker.Explanation.DefinitionErrors
-- Description : Explanations of messages about definitions, patterns, fields and declarations.
--
-- A rule for each family of messages that name no types which differ. Pure.
module Rosy.Worker.Explanation.DefinitionErrors
  ( definitionErrors,
  )
where

import Data.Char (isUpper)
import Data.List (nub)
import Data.Maybe (fromMaybe, listToMaybe, mapMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.CompilerMessage
import Rosy.Worker.Explanation.MessageParts
import Rosy.Worker.Explanation.MessageText
import Rosy.Worker.Explanation.NameErrors (ambiguousName, moduleErrors)
import Rosy.Worker.Explanation.OriginalVocabulary (originalOptionsHint)
import Rosy.Worker.Explanation.RobotVocabulary
import Rosy.Worker.Explanation.TypeMessages
import Rosy.Worker.Problem
import Rosy.Worker.Sentence

-- | The rules in their order.
definitionErrors :: [Rule]
definitionErrors =
  [ definedTwice,
    incompleteDefinition,
    ambiguousName,
    incompleteDo,
    sideOfEvent,
    patternArguments,
    fieldErrors,
    joinedComparisons,
    singleQuotes,
    typeArguments,
    misplacedExpression,
    switchedOffExtension,
    classErrors,
    instanceErrors,
    moduleErrors
  ]

-- | Two definitions or types of one name.
definedTwice :: Rule
definedTwice MessageParts {..}
  | states 29916 "Multiple declarations of" || states 10498 "Conflicting definitions for" = Just $ problem "duplicate" (trWith "‘{name}’ is defined twice." ["name" =: firstName]) (otherPlace (tr "Rename one of them, or put equations of the same function next to each other."))
  | states 31744 "Duplicate type signatures" = Just $ problem "duplicate" (trWith "‘{name}’ has two types." ["name" =: firstName]) (tr "Remove one of them.")
  | otherwise = Nothing
  where
    otherPlace advice = case nub (mapMaybe lineIn (filter ("Main.hs:" `Text.isPrefixOf`) (Text.words messageText))) of
      l : _ | Just l /= fmap (line . start) (messageSpan raw) -> trWith "The other is in line {line}: remove or rename one of them." ["line" =# l]
      _ -> advice
    lineIn w = readNumber (Text.takeWhile (/= ':') (Text.drop (Text.length "Main.hs:") w))

-- | A type without its definition, or equations that do not fit each other.
incompleteDefinition :: Rule
incompleteDefinition MessageParts {..}
  | states 44432 "lacks an accompanying binding" = Just $ problem "missing-definition" (trWith "‘{name}’ has a type but no definition." ["name" =: firstName]) (lacking everything)
  | states 91938 "different numbers of arguments" = Just $ problem "argument-count" (trWith "The equations of ‘{name}’ take different numbers of values." ["name" =: firstName]) (if any looseParts (maybe [] (\r -> take (line (end r) - line (start r) + 1) (drop (line (start r) - 1) (Text.lines (text outline)))) (messageSpan raw)) then tr "A pattern with parts needs brackets, for example: (Bumper _ Pressed)" else tr "Give each of them the same number of patterns: _ stands for anything.")
  | otherwise = Nothing

-- | A @do@ without its last line.
incompleteDo :: Rule
incompleteDo MessageParts {..}
  | states 55814 "The last statement in a 'do' block" = Just $ problem "incomplete" (tr "A do block cannot end like this.") (tr "Its last line says what to do: add one.")
  | mentions "Empty 'do' block" = Just $ problem "incomplete" (tr "Nothing follows this ‘do’.") (tr "Write what to do on the next line, indented.")
  | otherwise = Nothing

-- | @Left@ or @Right@ without its value, as the side of an event.
sideOfEvent :: Rule
sideOfEvent MessageParts {..}
  | firstName `elem` ["Left", "Right"], Just side <- lookup (lastWord before) [("Bumper", "BumperSide"), ("Cliff", "CliffSide"), ("Wheel", "WheelSide")], mentions "but has been given none" = Just $ problem "type-mismatch" (trWith "This is {a given}, but {a needed} is needed here." ["given" =: "Either a b", "needed" =: side]) (mismatchHint side "Either a b")
  | otherwise = Nothing
  where
    lastWord = maybe "" (Text.dropWhile (== '(')) . listToMaybe . reverse . Text.words

-- | A pattern with too many or too few parts.
patternArguments :: Rule
patternArguments MessageParts {..}
  | mentions "should have" && mentions "arguments, but has been given" || mentions "should have" && mentions "argument, but has been given" = Just $ case mapMaybe readNumber (Text.words (fromMaybe "" (after "should have" messageText))) of
    1 : 0 : _ -> problem "pattern-arguments" (trWith "‘{name}’ holds one value, but here none are named." ["name" =: firstName]) (withParts 1)
    wanted : 0 : _ -> problem "pattern-arguments" (trWith "‘{name}’ holds {count wanted} values, but here none are named." ["name" =: firstName, "wanted" =# wanted]) (withParts wanted)
    1 : given : _ -> problem "pattern-arguments" (trWith "‘{name}’ holds one value, but here {count given} are named." ["name" =: firstName, "given" =# given]) nameEach
    wanted : 1 : _ -> problem "pattern-arguments" (trWith "‘{name}’ holds {count wanted} values, but here one is named." ["name" =: firstName, "wanted" =# wanted]) nameEach
    wanted : given : _ -> problem "pattern-arguments" (trWith "‘{name}’ holds {count wanted} values, but here {count given} are named." ["name" =: firstName, "wanted" =# wanted, "given" =# given]) nameEach
    _ -> problem "pattern-arguments" (trWith "‘{name}’ does not hold that many values." ["name" =: firstName]) nameEach
  | otherwise = Nothing
  where
    withParts wanted = trWith "Write it with its parts in brackets: ({code})" ["code" =: Text.unwords (firstName : replicate wanted "_")]
    nameEach = tr "Name each of them: _ stands for one that is not needed."

-- | Fields that are missing or unknown.
fieldErrors :: Rule
fieldErrors MessageParts {..}
  | mentions "does not have the required strict field" = Just $ problem "missing-field" (trWith "This ‘{name}’ is not complete." ["name" =: firstName]) (trWith "Write it as ‘{name}’ and its values in order." ["name" =: firstName])
  | mentions "does not have field" = Just $ problem "unknown-field" (maybe (trWith "‘{name}’ has no field called that." ["name" =: firstName]) (\f -> trWith "‘{name}’ has no field called ‘{field}’." ["name" =: firstName, "field" =: f]) (listToMaybe (drop 1 names))) (trWith "Write it as ‘{name}’ and its values in order." ["name" =: firstName])
  | mentions "is not a (visible) field" || mentions "is not a record selector" = Just $ problem "unknown-field" (trWith "‘{name}’ is not a field." ["name" =: firstName]) (fromMaybe (tr "Write the constructor and its values in order.") (originalOptionsHint before))
  | otherwise = Nothing

-- | Two comparisons without a word between them.
joinedComparisons :: Rule
joinedComparisons MessageParts {..}
  | mentions "cannot mix" = Just $ problem "operator" (tr "Two comparisons cannot follow one another.") (if any (`elem` ["and", "or"]) (Text.words (fromMaybe "" (messageSpan raw >>= snippet (text outline)))) then tr "In Haskell, and is written &&, or is written ||." else tr "Join them with &&: 3 < s && s < 5")
  | otherwise = Nothing

-- | A text between single quotation marks.
singleQuotes :: Rule
singleQuotes MessageParts {..}
  | Just ('\'', _) <- Text.uncons =<< (messageSpan raw >>= snippet (text outline)) = Just $ problem "character" (tr "Single quotation marks are for one letter.") (tr "A text is written between double ones: \"hello\"")
  | otherwise = Nothing

-- | A type with too many or too few arguments.
typeArguments :: Rule
typeArguments MessageParts {..}
  | mentions "Expecting" && mentions "more argument" = Just $ problem "type-argument" (trWith "‘{name}’ needs another type beside it." ["name" =: firstName]) ofWhat
  | mentions "Expected kind" && mentions "but", typeHead (fromMaybe "" (listToMaybe (drop 1 names))) == "Task" = Just $ problem "type-argument" (tr "‘Task’ takes one type: what the task ends with.") (tr "Remove the first of the two, for example: Task ()")
  | mentions "Expected kind" && mentions "but" = Just $ problem "type-argument" (trWith "‘{type}’ is a complete type: nothing can follow it." ["type" =: typeHead (fromMaybe "" (listToMaybe (drop 1 names)))]) (tr "Remove what comes after it, or put an arrow -> between.")
  | mentions "Expected a type, but" || mentions "Expected a constraint" = Just $ problem "type-argument" (trWith "‘{name}’ cannot be used in this place of a type." ["name" =: firstName]) (if maybe False (Text.isInfixOf "=>" . lineAt outline) (messageSpan raw) then tr "An arrow -> goes between what a function takes and what it gives." else tr "Check the type for a missing arrow or bracket.")
  | otherwise = Nothing
  where
    ofWhat
      | firstName == "Memory" = trWith "Say what is remembered, for example: {example}" ["example" =: exampleOf firstName]
      | firstName `elem` ["Task", "Done"] = trWith "Say with what it ends, for example: {example}" ["example" =: exampleOf firstName]
      | otherwise = trWith "Say of what, for example: {example}" ["example" =: exampleOf firstName]

-- | An expression in a pattern, or the other way round.
misplacedExpression :: Rule
misplacedExpression MessageParts {..}
  | mentions "Parse error in pattern" || mentions "Pattern syntax in expression" = Just $ problem "pattern" (tr "This cannot be on the left of an equals sign.") (tr "Write names, constructors and _ there, each with brackets around it if it has parts.")
  | otherwise = Nothing

-- | A language extension that is not switched on.
switchedOffExtension :: Rule
switchedOffExtension MessageParts {..}
  | mentions "Illegal" || mentions "Perhaps you intended to use" || mentions "Perhaps you meant to use" = Just $ problem "extension" (tr "This needs a language extension that is not switched on.") (tr "There is nearly always a simpler way to say it.")
  | otherwise = Nothing

-- | A class, a newtype or an instance that is not complete.
classErrors :: Rule
classErrors MessageParts {..}
  | states 54721 "method of class" = Just $ problem "unknown-method" (maybe (trWith "This class has nothing called ‘{name}’." ["name" =: firstName]) (\c -> trWith "‘{class}’ has nothing called ‘{name}’." ["class" =: c, "name" =: firstName]) (listToMaybe (drop 1 names))) (tr "Write one of the names that are in the class.")
  | states 23517 "newtype must have exactly one" = Just $ problem "newtype" (tr "A newtype holds exactly one value.") (tr "For more than one, write data.")
  | mentions "No explicit implementation" = Just $ problem "missing-method" (tr "This instance is not complete.") (tr "Define its functions as well.")
  | otherwise = Nothing

-- | An instance that exists already.
instanceErrors :: Rule
instanceErrors MessageParts {..}
  | states 59692 "Duplicate instance declarations",
    (c, t) : _ <- [(c, t) | c <- ["Sensor", "Command"], Just t <- [between ("instance " <> c <> " ") " -- Defined in ‘Rosy." messageText]] =
    Just $ problem "duplicate" (if c == "Sensor" then trWith "The robot has a sensor ‘{type}’ already." ["type" =: t] else trWith "The robot has a command ‘{type}’ already." ["type" =: t]) (trWith "Remove this declaration. For a topic of your own declare a type: newtype My{type} = My{type} {type}" ["type" =: t])
  | states 59692 "Duplicate instance declarations" = Just $ problem "duplicate" (tr "Rosy has done this for you already.") (tr "Remove this declaration.")
  | otherwise = Nothing

-- | Whether the left side of an equation applies a constructor without brackets.
looseParts :: Text -> Bool
looseParts l = or (zipWith (\w next -> isConstructor w && next /= "=") ws (drop 1 ws))
  where
    ws = drop 1 (Text.words (fst (Text.breakOn " = " l)))
    isConstructor w = maybe False (isUpper . fst) (Text.uncons w)

readNumber :: Text -> Maybe Int
readNumber "none" = Just 0
readNumber t = case reads (Text.unpack (Text.dropWhileEnd (`elem` (".,:" :: String)) t)) of
  [(n, "")] -> Just n
  _ -> Nothing

typeHead :: Type -> Type
typeHead t = fromMaybe t (listToMaybe (typeAtoms t))

lacking :: Text -> Sentence
lacking everything = case maybe [] quotedParts (after "Perhaps you meant" everything) of
  x : _ -> trWith "Did you mean {or names}?" ["names" =* [x]]
  [] -> tr "Write an equation for it below its type."
