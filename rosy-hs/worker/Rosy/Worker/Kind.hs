{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Kind
-- Description : What the compiler said, in words for learners.
--
-- Takes each message apart (its reason, its parts, the types in it) and says the same in two short sentences: first what,
-- then why or what to do. GHC 9.0 keeps its messages as documents, so some of this reads text; all such reading is in
-- this module and its folder. What is not understood keeps its place and GHC's own words.
module Rosy.Worker.Kind
  ( explainAll,
  )
where

import Data.Char (isAlphaNum, isDigit, isUpper)
import Data.List (nub, nubBy)
import Data.Maybe (catMaybes, fromMaybe, listToMaybe, mapMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.Kind.Fix (fixesFor, nearMisses)
import Rosy.Worker.Kind.Imports (importFor, moduleOf)
import Rosy.Worker.Kind.Nouns
import Rosy.Worker.Kind.Syntax (explainSyntax)
import Rosy.Worker.Kind.Types
import Rosy.Worker.Kind.Words
import Rosy.Worker.Problem
import Rosy.Worker.Raw

-- | All messages about a program as problems, in the order of the text; consequences of others left out.
explainAll :: Outline -> [Raw] -> [Problem]
explainAll outline = withoutEchoes . map explained . filter worthwhile
  where
    explained raw = mended raw (located outline ((explain outline raw) {ghc = original raw}))
    mended raw p = p {fixes = fixesFor outline raw p}
    -- Rosy says this itself.
    worthwhile raw = not ("The IO action ‘main’ is not defined" `Text.isPrefixOf` Text.concat (take 1 (important raw)))

-- | GHC's own words without what Rosy added.
original :: Raw -> Text
original raw = Text.strip (scrub (Text.intercalate "\n" (filter (not . Text.null . Text.strip) (map dull (important raw) ++ context raw ++ supplementary raw))))
  where
    -- The instances that GHC happens to know are no help to anybody.
    dull t = Text.unlines (takeWhile (not . isNoise) (Text.lines t))
    isNoise l = any (`Text.isInfixOf` l) ["These potential instance", "There are instances for similar types", "Matching instances:"]

-- | Adds the function that a problem is about.
located :: Outline -> Problem -> Problem
located outline p = case function p of
  Just _ -> p
  Nothing -> p {function = place p >>= enclosing outline}

enclosing :: Outline -> Span -> Maybe Text
enclosing outline s = listToMaybe [n | (n, within) <- bindings outline ++ signatures outline, start within <= start s, end s <= end within]

-- | One problem a place, and nothing that only follows from something else.
withoutEchoes :: [Problem] -> [Problem]
withoutEchoes ps = nubBy (\x y -> place x == place y && kind x == kind y) (filter (not . echo) ps)
  where
    at p k = [q | q <- ps, function q == function p, kind q == k]
    causes = [function p | p <- ps, kind p `elem` ["hole", "not-in-scope", "unit", "negative-number", "too-many-arguments"]]
    echo p =
      kind p `elem` ["ambiguous-type", "not-a-sensor", "not-a-command"] && (function p `elem` causes || Just "main" `elem` causes)
        || kind p == "ambiguous-type" && any ((< place p) . place) (at p "ambiguous-type")
        || kind p == "function-as-value" && not (null (at p "negative-number"))
        || kind p == "missing-field" && not (null (at p "unknown-field"))
        || kind p == "pattern-arguments" && any ((== place p) . place) (at p "type-mismatch")
        || kind p `elem` ["type-mismatch", "function-as-value"] && any (sameLine p) (at p "operator")
        || kind p == "type-mismatch" && any (\q -> kind q == "calculation" && sameLine p q) ps
        || kind p == "ambiguous-type" && any (sameLine p) (at p "missing-controller")
        || kind p == "ambiguous-type" && any ((< place p) . place) (at p "type-mismatch")
        || kind p `elem` ["type-mismatch", "missing-argument", "memory-types"] && any (sameLine p) (at p "operator")
        || kind p == "missing-argument" && any (sameLine p) (at p "arguments-with-commas" ++ at p "negative-number")
        || kind p == "operator" && any (\q -> sameLine p q && message q == message p && place q < place p) (at p "operator")
        || kind p == "too-many-arguments" && any (sameLine p) (at p "unit")
        || kind p == "ambiguous-type" && any (sameLine p) (at p "operator")
        || kind p == "main-type" && any ((< place p) . place) (at p "main-type")
    sameLine p q = fmap (line . start) (place p) == fmap (line . start) (place q)

-- | The kind and the sentences for one message.
explain :: Outline -> Raw -> Problem
explain outline raw = case reason raw of
  Syntax -> explainSyntax (text outline) said (region raw)
  Tabs -> problem "tab" "There is a tab in the program." "Use spaces: how wide a tab is depends on who looks at it."
  Hole -> hole
  Scope -> notInScope
  IncompletePatterns -> missingCases
  OverlappingPatterns -> problem "unreachable" "This case is never reached." "The cases above it take everything already."
  MissingFields -> problem "missing-field" "A value is missing in this record." ("Give it a value too" <> maybe "." (\f -> ": " <> f <> ".") (listToMaybe (drop 1 (quotes said))))
  MissingMethods -> problem "missing-method" "This instance is not complete." ("Define " <> sentenceList (quotes said) <> " as well.")
  Other -> problem "other" "The compiler has a remark about this." "Its own words are one click away."
  Types -> fromMaybe unknown (listToMaybe (catMaybes [shape, explainTypes outline raw]))
  where
    said = flat (Text.unwords (important raw))
    everything = flat (Text.unwords (important raw ++ context raw ++ supplementary raw))
    problem k m h = Problem (gravity raw) k (region raw) Nothing m h "" []
    names = quotes said
    firstName = fromMaybe "this" (listToMaybe names)
    saying t = t `Text.isInfixOf` said
    unknown = problem "other" "The compiler does not accept this." "Its own words are one click away."

    -- What is missing, and which names at hand would fit.
    hole = case between "::" "Where:" (fst (Text.breakOn " Or perhaps ‘" said)) of
      Just wanted
        | Text.length wanted > 2 ->
          let t = simple wanted
              fits = take 3 [n | (n, u) <- atHand everything, simple u == t]
           in problem "hole" "Something is missing here." (if null fits then "What fits is " <> a t <> "." else "What fits is " <> a t <> ", for example " <> sentenceList fits <> ".")
      _ -> problem "hole" "Something is missing here." "Put a value in this place."

    notInScope
      | Just advice <- unitOf unknownName, endsInNumber before = problem "unit" "A number stands without its unit." advice
      | behindDot = problem "operator" "A value has no parts behind a dot." "Take it apart with a pattern, for example: (Position x y)."
      | Text.isPrefixOf "(" unknownName = problem "operator" ("There is no sign " <> quoted sign <> ".") (fromMaybe (nearMiss everything sign) (foreignName sign))
      | otherwise = problem "not-in-scope" ("There is nothing called " <> quoted unknownName <> ".") (fromMaybe (nearMiss everything unknownName) (foreignName unknownName))
    endsInNumber = maybe False (isDigit . snd) . Text.unsnoc . Text.stripEnd
    unknownName = Text.takeWhile (/= ' ') (fromMaybe "?" (after "not in scope: " said))
    sign = Text.dropAround (`elem` ("()" :: String)) unknownName
    before = maybe "" (\s -> Text.take (column (start s) - 1) (lineOf s)) (region raw)
    lineOf s = fromMaybe "" (listToMaybe (drop (line (start s) - 1) (Text.lines (text outline))))
    -- As in p.x: the dot touches both.
    behindDot = case Text.unsnoc before of
      Just (rest, '.') | Just (_, c) <- Text.unsnoc rest -> isAlphaNum c || c == ')'
      _ -> False

    missingCases =
      let missing = maybe [] (filter (not . Text.null) . map Text.strip . Text.lines) (after "Patterns not matched:" (Text.unlines (important raw)))
          more = length missing - 1
          owner = fromMaybe "" (between "equation for ‘" "’" said)
       in problem
            "missing-cases"
            (if Text.null owner then "This says nothing about some cases." else quoted owner <> " says nothing about some cases.")
            ( case missing of
                [] -> "Add an equation for what is left."
                [m] | anything m, guarded -> "Add a last line: | otherwise = …"
                m : _ -> "Add one for " <> quoted (plainPattern m) <> (if more > 0 then ", and for " <> number more <> " more." else ".")
            )

    -- Nothing of it is looked at, so it is a guard that is missing.
    anything m = all (== "_") (drop 1 (Text.words m))
    guarded = maybe False (\s -> any (("|" `Text.isPrefixOf`) . Text.stripStart) (take (line (end s) - line (start s) + 1) (drop (line (start s) - 1) (Text.lines (text outline))))) (region raw)

    -- Messages about the form of a program, which have no types in them.
    shape
      | Just rest <- after "Not in scope: " said = Just (undefinedThing rest)
      | saying "not in scope:" = Just notInScope
      | saying "Multiple declarations of" || saying "Conflicting definitions for" = Just (problem "duplicate" (quoted firstName <> " is defined twice.") (otherPlace "Rename one of them, or put equations of the same function next to each other."))
      | saying "Duplicate type signatures" = Just (problem "duplicate" (quoted firstName <> " has two types.") "Remove one of them.")
      | saying "lacks an accompanying binding" = Just (problem "missing-definition" (quoted firstName <> " has a type but no definition.") (lacking everything))
      | saying "different numbers of arguments" = Just (problem "argument-count" ("The equations of " <> quoted firstName <> " take different numbers of values.") (if any looseParts (maybe [] (\r -> take (line (end r) - line (start r) + 1) (drop (line (start r) - 1) (Text.lines (text outline)))) (region raw)) then "A pattern with parts needs brackets, for example: (Bumper _ Pressed)." else "Give each of them the same number of patterns: _ stands for anything."))
      | saying "Ambiguous occurrence" = Just (problem "ambiguous-name" (quoted firstName <> " is the name of two things.") (whichOne firstName everything))
      | saying "The last statement in a 'do' block" = Just (problem "incomplete" "A do block cannot end like this." "Its last line says what to do: add one.")
      | saying "Empty 'do' block" = Just (problem "incomplete" "Nothing follows this ‘do’." "Write what to do on the next line, indented.")
      | saying "should have" && saying "arguments, but has been given" || saying "should have" && saying "argument, but has been given" = Just (patternArguments firstName)
      | saying "does not have the required strict field" = Just (problem "missing-field" ("This " <> quoted firstName <> " is not complete.") ("Write it as " <> quoted firstName <> " and its values in order."))
      | saying "does not have field" = Just (problem "unknown-field" (quoted firstName <> " has no field called " <> maybe "that" quoted (listToMaybe (drop 1 names)) <> ".") ("Write it as " <> quoted firstName <> " and its values in order."))
      | saying "is not a (visible) field" || saying "is not a record selector" = Just (problem "unknown-field" (quoted firstName <> " is not a field.") "Write the constructor and its values in order.")
      | saying "cannot mix" = Just (problem "operator" "Two comparisons cannot follow one another." (if any (`elem` ["and", "or"]) (Text.words (fromMaybe "" (region raw >>= snippet (text outline)))) then "In Haskell, and is written &&, or is written ||." else "Join them with &&: 3 < s && s < 5."))
      | Just ('\'', _) <- Text.uncons =<< (region raw >>= snippet (text outline)) = Just (problem "character" "Single quotation marks are for one letter." "A text stands between double ones: \"hello\".")
      | saying "Expecting" && saying "more argument" = Just (problem "type-argument" (quoted (fromMaybe firstName (listToMaybe names)) <> " needs another type beside it.") ((if firstName == "Memory" then "Say what is remembered, for example: " else if firstName `elem` ["Task", "Done"] then "Say with what it ends, for example: " else "Say of what, for example: ") <> exampleOf firstName <> "."))
      | saying "Expected kind" && saying "but" = Just (problem "type-argument" (quoted (typeHead (fromMaybe "" (listToMaybe (drop 1 names)))) <> " is a complete type: nothing can follow it.") "Remove what stands behind it, or put an arrow -> between.")
      | saying "Expected a type, but" || saying "Expected a constraint" = Just (problem "type-argument" (quoted firstName <> " cannot stand in this place of a type.") (if maybe False (Text.isInfixOf "=>" . lineOf) (region raw) then "Between what a function takes and what it gives stands ->." else "Check the type for a missing arrow or bracket."))
      | saying "Parse error in pattern" || saying "Pattern syntax in expression" = Just (problem "pattern" "This cannot stand on the left of an equals sign." "Write names, constructors and _ there, each with brackets around it if it has parts.")
      | saying "Illegal" || saying "Perhaps you intended to use" || saying "Perhaps you meant to use" = Just (problem "extension" "This needs a language extension that is not switched on." "There is nearly always a simpler way to say it.")
      | saying "method of class" = Just (problem "unknown-method" (maybe "This class" quoted (listToMaybe (drop 1 names)) <> " has nothing called " <> quoted firstName <> ".") "Write one of the names that stand in the class.")
      | saying "newtype must have exactly one" = Just (problem "newtype" "A newtype holds exactly one value." "For more than one, write data.")
      | saying "No explicit implementation" = Just (problem "missing-method" "This instance is not complete." "Define its functions as well.")
      | saying "Duplicate instance declarations" = Just (problem "duplicate" "Rosy has done this for you already." "Remove this instance.")
      | saying "does not export" = Just (problem "not-in-scope" ("The module " <> quoted firstName <> " has no " <> maybe "such name" quoted (listToMaybe (drop 1 names)) <> ".") "Check its spelling.")
      | saying "Could not find module" || saying "Could not load module" = Just (problem "import" ("The module " <> quoted firstName <> " is not available here.") "Remove this import.")
      | otherwise = Nothing

    undefinedThing rest
      | Just advice <- unitOf firstName, endsInNumber before = problem "unit" "A number stands without its unit." advice
      | "A data constructor of that name" `Text.isInfixOf` said = problem "not-a-type" (quoted firstName <> " is a value, not a type.") (fromMaybe "In a type, write the type that it belongs to." (typeOfValue firstName))
      | "type variable" `Text.isPrefixOf` rest = problem "not-in-scope" ("There is no type called " <> quoted firstName <> ".") "Types begin with capital letters, for example: Turn Double."
      | "No module named" `Text.isInfixOf` everything,
        qualifier <- fromMaybe "" (listToMaybe (drop 1 names)) =
        problem "not-in-scope" (quoted qualifier <> " is not imported.") (importHint qualifier)
      | "type constructor or class" `Text.isPrefixOf` rest = problem "not-in-scope" ("There is no type called " <> quoted firstName <> ".") (fromMaybe (if amongValues then "If it is one more value of this type, write | in front of it." else nearMiss everything firstName) (foreignName firstName))
      | otherwise = problem "not-in-scope" ("There is nothing called " <> quoted firstName <> ".") (fromMaybe (nearMiss everything firstName) (foreignName firstName))

    -- As in: data Mode = Go Stop
    amongValues = null (nearMisses everything firstName) && "data" `elem` take 1 (Text.words (maybe "" lineOf (region raw))) && "=" `Text.isInfixOf` before

    patternArguments c =
      let counts = mapMaybe readNumber (Text.words (fromMaybe "" (after "should have" said)))
       in case counts of
            wanted : 0 : _ -> problem "pattern-arguments" (quoted c <> " holds " <> number wanted <> (if wanted == 1 then " value" else " values") <> ", but here none are named.") ("Write it with its parts in brackets: (" <> Text.unwords (c : replicate wanted "_") <> ").")
            wanted : given : _ -> problem "pattern-arguments" (quoted c <> " holds " <> number wanted <> (if wanted == 1 then " value" else " values") <> ", but here " <> (if given == 1 then "one is" else number given <> " are") <> " named.") "Name each of them: _ stands for one that is not needed."
            _ -> problem "pattern-arguments" (quoted c <> " does not hold that many values.") "Name each of them: _ stands for one that is not needed."

    otherPlace advice = case nub (mapMaybe lineIn (filter ("Main.hs:" `Text.isPrefixOf`) (Text.words said))) of
      l : _ | Just l /= fmap (line . start) (region raw) -> "The other is in line " <> Text.pack (show l) <> ": rename one of them."
      _ -> advice
    lineIn w = readNumber (Text.takeWhile (/= ':') (Text.drop (Text.length "Main.hs:") w))

-- | Whether the left side of an equation has a constructor with something behind it and no brackets around both.
looseParts :: Text -> Bool
looseParts l = or (zipWith (\w next -> isConstructor w && next /= "=") ws (drop 1 ws))
  where
    ws = drop 1 (Text.words (fst (Text.breakOn " = " l)))
    isConstructor w = maybe False (isUpper . fst) (Text.uncons w)

-- | A missing pattern without the brackets that a pair does not need: @((A b), (C d))@ is @(A b, C d)@.
plainPattern :: Text -> Text
plainPattern m = case Text.stripPrefix "(" m >>= Text.stripSuffix ")" of
  Just inside | "," `Text.isInfixOf` inside -> "(" <> Text.intercalate ", " (map bare (parts (0 :: Int) "" (Text.unpack inside))) <> ")"
  _ -> m
  where
    parts _ acc [] = [Text.strip acc]
    parts n acc (c : cs)
      | c == ',', n == 0 = Text.strip acc : parts 0 "" cs
      | otherwise = parts (if c == '(' then n + 1 else if c == ')' then n - 1 else n) (Text.snoc acc c) cs
    bare t = fromMaybe t (Text.stripPrefix "(" t >>= Text.stripSuffix ")" >>= \inner -> if Text.any (`elem` ("()," :: String)) inner then Nothing else Just inner)

readNumber :: Text -> Maybe Int
readNumber "none" = Just 0
readNumber t = case reads (Text.unpack (Text.dropWhileEnd (`elem` (".,:" :: String)) t)) of
  [(n, "")] -> Just n
  _ -> Nothing

typeHead :: Type -> Type
typeHead t = fromMaybe t (listToMaybe (atoms t))

-- | Asks whether another name was meant.
nearMiss :: Text -> Text -> Text
nearMiss everything unknownName = case nearMisses everything unknownName of
  [] -> maybe "Check its spelling, or define it." (\m -> "It comes with Haskell: write at the top: import " <> m <> " (" <> unknownName <> ").") (importFor unknownName)
  xs -> "Did you mean " <> sentenceList (take 3 xs) <> "?"

-- | What to do about a name that comes from two places. One of them may be the program itself.
whichOne :: Text -> Text -> Text
whichOne name everything
  | "defined at" `Text.isInfixOf` everything = maybe "Give yours another name." (\m -> "One comes from " <> m <> ": give yours another name.") (listToMaybe modules)
  | m : _ <- filter (`notElem` ["Prelude", "Rosy"]) modules = "Keep what comes from " <> m <> " apart: write import qualified " <> m <> " as " <> shortOf m <> ", and then " <> shortOf m <> "." <> name <> "."
  | otherwise = "Write the module in front of it."
  where
    modules = [Text.takeWhile (/= '’') t | t <- drop 1 (Text.splitOn "imported from ‘" everything)]
    shortOf m = last (Text.splitOn "." m)

lacking :: Text -> Text
lacking everything = case maybe [] quotes (after "Perhaps you meant" everything) of
  x : _ -> "Did you mean " <> quoted x <> "?"
  [] -> "Write an equation for it below its type."

importHint :: Text -> Text
importHint q = case moduleOf q of
  Just m -> "Write at the top: import qualified " <> m <> " as " <> q <> "."
  Nothing -> "Import the module, or leave out what stands before the dot."

-- | The local names that GHC lists, with their types.
atHand :: Text -> [(Text, Type)]
atHand everything = maybe [] entries (after "Relevant bindings include" everything)
  where
    entries t = case Text.breakOn " :: " t of
      (_, rest) | Text.null rest -> []
      (before, rest) ->
        let (type', more) = Text.breakOn " (bound at" (Text.drop 4 rest)
         in (fromMaybe "" (listToMaybe (reverse (Text.words before))), type') : entries (Text.drop 1 (Text.dropWhile (/= ')') more))
