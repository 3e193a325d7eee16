{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Explanation.AmbiguousTypes
-- Description : Explanations of types that the program leaves open.
--
-- Covers type variables of which too little is known, and functions that do not say what they sense or give.
module Rosy.Worker.Explanation.AmbiguousTypes
  ( explainAmbiguous,
    feedbackOfWhat,
    unclear,
  )
where

import Control.Applicative ((<|>))
import Data.Char (isAlphaNum, isLower)
import Data.List (find)
import Data.Maybe (fromMaybe, listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.CompilerMessage
import Rosy.Worker.Explanation.MessageText
import Rosy.Worker.Explanation.TypeMessages
import Rosy.Worker.Problem
import Rosy.Worker.Sentence

-- | Explains an ambiguous type. Takes the type variable, the class, and the expression that requires it.
explainAmbiguous :: ProgramOutline -> Say -> Text -> Text -> Text -> Problem
explainAmbiguous outline problem v c user
  | letter == "feed" = feedbackOfWhat problem
  | Text.length letter > 2 = blamedFor letter (problem "lower-case-type" (trWith "‘{type}’ stands for any type, because it begins with a small letter." ["type" =: letter]) (trWith "Write the type with a capital letter: {capital}" ["capital" =: capital letter]))
  | c `elem` ["Sensor", "Command", "Controller", "Runnable", "Ends", "Default", "Value"] = unclear outline problem
  | user `elem` ["read", "fromIntegral", "realToFrac"] = problem "ambiguous-type" (trWith "It is not clear which type ‘{function}’ gives here." ["function" =: user]) (tr "Say it, for example: (read \"1\" :: Double)")
  | otherwise = problem "ambiguous-type" (tr "It is not clear which type this value has.") (tr "Say it after the value, for example: (1 :: Double)")
  where
    letter = Text.dropWhileEnd (`elem` ("0123456789" :: String)) v
    capital t = Text.toUpper (Text.take 1 t) <> Text.drop 1 t
    blamedFor t p = case [(called f, s) | f <- connectedTo outline, Just s <- [typePlace outline (called f) t]] of
      (f, s) : _ -> p {function = Just f, place = Just s}
      [] -> p

-- | The type of feedback is ambiguous.
feedbackOfWhat :: Say -> Problem
feedbackOfWhat problem = problem "ambiguous-type" (tr "It is not clear of which type this feedback is.") (tr "Say it where it is taken, for example: \\x -> Say (show (x :: Double))")

-- | A function whose inputs or outputs are ambiguous.
unclear :: ProgramOutline -> Say -> Problem
unclear outline problem = case find (any isOpen . (\f -> inputs f ++ outputs f)) (connectedTo outline) of
  Just f ->
    let p = case (lookup (called f) (signatures outline), atVelocity =<< lookup (called f) (typesOfNames outline)) of
          (Just _, Just t) -> problem "ambiguous-type" (trWith "‘{function}’ works at many types, and it is not said at which." ["function" =: called f]) (trWith "Say it where it is used: ({function} :: {type})" ["function" =: called f, "type" =: t])
          (Just _, Nothing) -> problem "ambiguous-type" (trWith "‘{function}’ works at many types, and it is not said at which." ["function" =: called f]) (tr "Write the types that are meant in place of the small letters of its type.")
          (Nothing, t) -> problem "ambiguous-type" (trWith "‘{function}’ does not say what it senses or gives." ["function" =: called f]) (trWith "Write its type above it, for example: {code}" ["code" =: called f <> " :: " <> fromMaybe "Bumper -> Maybe Sound" t])
     in p {function = Just (called f), place = (lookup (called f) (signatures outline) <|> lookup (called f) (bindings outline)) <|> place p}
  Nothing | Just w <- looseForever -> problem "too-many-arguments" (tr "‘forever’ takes only what comes right after it.") (trWith "Put brackets around the task: forever ({task})" ["task" =: w])
  Nothing -> problem "ambiguous-type" (tr "This does not say what it senses or gives.") (tr "Write its type above it, for example: f :: Bumper -> Maybe Sound")
  where
    -- forever say "x"
    looseForever = listToMaybe [rest | l <- Text.lines (text outline), Just more <- [after "forever " l], let rest = Text.strip (Text.takeWhile (`notElem` (")" :: String)) more), w : _ : _ <- [Text.words rest], maybe False (isLower . fst) (Text.uncons w), w /= "do", not ("$" `Text.isInfixOf` rest)]
    isOpen = any (maybe False (isLower . fst) . Text.uncons) . Text.words . Text.map (\x -> if isAlphaNum x || x `elem` ("_'" :: String) then x else ' ')

-- | A type with 'Velocity' for its variables; nothing if they have constraints.
atVelocity :: Type -> Maybe Type
atVelocity t
  | "=>" `Text.isInfixOf` t = Nothing
  | otherwise = Just (Text.concat (map atom (Text.groupBy (\x y -> isName x == isName y) t)))
  where
    isName x = isAlphaNum x || x `elem` ("_'" :: String)
    atom w = if maybe False (isLower . fst) (Text.uncons w) then "Velocity" else w
