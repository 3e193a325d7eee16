{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Explanation
-- Description : Explanations of compiler messages in sentences for learners.
--
-- Analyses each message (category, parts, types) and states the problem in two short sentences: what is wrong, then why or what to do.
-- What GHC states as data ('finding', 'messageCode') comes first; prose is matched where it states none, in this module and its folder. A message
-- that is not recognised keeps its position and GHC's wording.
module Rosy.Worker.Explanation
  ( explainAll,
    withoutHiddenEnds,
  )
where

import Control.Applicative ((<|>))
import Control.Monad (mfilter)
import Data.Char (isAlphaNum, isDigit, isUpper)
import Data.List (nub, nubBy)
import Data.Maybe (catMaybes, fromMaybe, listToMaybe, mapMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.CompilerMessage
import Rosy.Worker.Explanation.ConfusableCharacters (explainConfusable)
import Rosy.Worker.Explanation.EmptyPlaces (whatFits)
import Rosy.Worker.Explanation.ImportSuggestions (moduleExporting, moduleForAlias)
import Rosy.Worker.Explanation.MessageText
import Rosy.Worker.Explanation.MissingCases (explainMissingCases)
import Rosy.Worker.Explanation.OriginalVocabulary (originalOptionsHint)
import Rosy.Worker.Explanation.QuickFixes (nearMisses, quickFixes)
import Rosy.Worker.Explanation.RobotVocabulary
import Rosy.Worker.Explanation.SyntaxErrors (explainSyntax)
import Rosy.Worker.Explanation.TextRepair (Program (source, tokens), capitalised, chunkOf, edited, isName, lineAfter, ownerOf, programOf)
import Rosy.Worker.Explanation.TextualMistakes (textualMistakes)
import Rosy.Worker.Explanation.Tokenizer (Token (from, word))
import Rosy.Worker.Explanation.TypeErrors
import Rosy.Worker.Problem
import Rosy.Worker.Sentence

-- | Explains all messages of a program in source order; drops consequences of other messages. Takes also the problems that
-- "Rosy.Worker.Ghc" found itself. A mistake that the text shows replaces what the compiler says about it.
explainAll :: ProgramOutline -> [Problem] -> [CompilerMessage] -> [Problem]
explainAll outline refused raws = withoutConsequences (filter (not . isSettled) refused ++ shown ++ filter (not . isRepeated) (map explained (filter worthwhile left)))
  where
    errors = [raw | raw <- raws, messageSeverity raw == Error || category raw `elem` [Hole, Scope]]
    program = programOf (text outline)
    -- The text is searched only where the compiler found an error.
    suspected = if null errors && not (any isError refused) then [] else textualMistakes program
    shown = [named (located outline (m {ghc = Text.intercalate "\n\n" (map original (filter (isAbout program m) errors))})) | m <- suspected, any (isAbout program m) errors || null errors && any isError refused]
    -- What the compiler took for a function may be removed by the repair: @int@ in @int speed = 5@.
    named m = case (function m, place m) of
      (Just f, Just s)
        | any (any (Text.null . by) . edits) (fixes m),
          mendedProgram <- programOf (edited (concatMap edits (take 1 (fixes m))) (text outline)),
          f `notElem` map word (tokens mendedProgram) ->
          m {function = mfilter isName (ownerOf mendedProgram (line (start s)))}
      _ -> m
    left = filter (\raw -> not (any (\m -> isAbout program m raw) shown && raw `elem` errors)) raws
    -- A repair that writes or moves main gives the program one.
    isSettled p = or [start a <= start b && kind p == "missing-equals" | Just a <- [place p], Just b <- map place shown] || kind p == "no-main" && or [kind m == "main-type" || any ((== "main") . by) es || kind m == "syntax" && all ((== 1) . column . start . replaces) es | m <- shown, f <- fixes m, let es = edits f]
    -- A problem whose place is found by the explanation.
    isRepeated p = isError p && or [line (start a) == line (start b) | Just a <- [place p], Just b <- map place shown]
    explained raw = mended raw (located outline ((explain outline raw) {ghc = original raw}))
    mended raw p = explainConfusable (text outline) raw (withLine p {fixes = quickFixes outline raw p})
    -- The place of a quotation mark is easier to see than to describe.
    withLine p = case (kind p, place p, fixes p) of
      ("missing-quote", Just s, [f]) -> p {hint = lineAfter (edits f) (text outline) (start s)}
      _ -> p
    -- Reported by "Rosy.Worker.Ghc" itself.
    worthwhile raw = not ("The IO action ‘main’ is not defined" `Text.isPrefixOf` Text.concat (take 1 (important raw)))

-- | Whether a message may be a consequence of a mistake in the text: it is about the same definition or a place that the repair changes, it stands
-- where parsing ended, or it misses a name that stands on the same line.
isAbout :: Program -> Problem -> CompilerMessage -> Bool
isAbout program m raw = case (place m, messageSpan raw) of
  (Just here, Just there)
    | category raw == Syntax -> chunk (start here) <= chunk (start there)
    | otherwise ->
      owner (start here) == owner (start there)
        -- What a function without a type means is missed where it is used.
        || isAmbiguous && maybe False (`elem` [word t | t <- tokens program, owner (from t) == owner (start there)]) (owner (start here))
        || or [start r <= start there && end there <= end r || start there < start r && end r <= end there && line (start there) == line (end there) | f <- fixes m, e <- edits f, let r = replaces e]
        || "not in scope" `Text.isInfixOf` Text.unwords (important raw) && textAt (source program) there `elem` [word t | t <- tokens program, line (from t) == line (start here)]
  (_, Nothing) -> True
  _ -> False
  where
    isAmbiguous = any (`Text.isInfixOf` Text.toLower (Text.unwords (important raw))) ["ambiguous", "overlapping instances"]
    chunk = chunkOf program . line
    owner = ownerOf program . line

-- | A @Done@ of the program's own is why the end of a task is not known: of the two problems the declaration's stays, as an error.
withoutHiddenEnds :: [Problem] -> [Problem]
withoutHiddenEnds ps
  | any hidesDone ps, any isUnknownEnd ps = [if hidesDone p then p {severity = Error} else p | p <- ps, not (isUnknownEnd p)]
  | otherwise = ps
  where
    hidesDone p = kind p == "hides-rosy" && "‘Done’" `Text.isInfixOf` english (message p)
    isUnknownEnd p = kind p == "ambiguous-type" && "with what this task ends" `Text.isInfixOf` english (message p)

-- | GHC's wording without generated names.
original :: CompilerMessage -> Text
original raw = maybe "" (\n -> "[GHC-" <> Text.justifyRight 5 '0' (Text.pack (show n)) <> "] ") (messageCode raw) <> Text.strip (withoutGeneratedNames (Text.intercalate "\n" (filter (not . Text.null . Text.strip) (map dull (important raw) ++ context raw ++ supplementary raw))))
  where
    -- Lists of known instances do not help learners.
    dull t = Text.unlines (takeWhile (not . isNoise) (Text.lines t))
    isNoise l = any (`Text.isInfixOf` l) ["These potential instance", "There are instances for similar types", "Matching instances:"]

-- | Adds the enclosing function.
located :: ProgramOutline -> Problem -> Problem
located outline p = case function p of
  Just _ -> p
  Nothing -> p {function = place p >>= enclosing outline}

-- | Removes duplicates at the same position and consequences of other problems.
withoutConsequences :: [Problem] -> [Problem]
withoutConsequences ps = nubBy (\x y -> place x == place y && kind x == kind y) (filter (not . isConsequence) ps)
  where
    at p k = [q | q <- ps, function q == function p, kind q == k]
    causes = [function p | p <- ps, kind p `elem` ["hole", "not-in-scope", "unit", "negative-number", "too-many-arguments"]]
    isConsequence p =
      kind p `elem` ["ambiguous-type", "not-a-sensor", "not-a-command"] && (function p `elem` causes || Just "main" `elem` causes)
        || kind p `elem` ["type-mismatch", "function-as-value", "missing-argument", "memory-types", "ambiguous-type"] && any (sameLine p) (at p "character")
        || isAboutHole p
        || kind p == "ambiguous-type" && any ((< place p) . place) (at p "ambiguous-type")
        || kind p == "function-as-value" && not (null (at p "negative-number"))
        || kind p == "missing-field" && not (null (at p "unknown-field"))
        || kind p == "too-many-arguments" && any isRobot (at p "not-in-scope")
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
    -- The type of an expression that depends on what is put into its empty places.
    isAboutHole p = or [isAround || isOverlap && names q p | q <- ps, kind q == "hole", "ambiguous type variable" `Text.isInfixOf` ghc q, Just s <- [place q], let isAround = (isOverlap || kind p `elem` ["ambiguous-type", "lower-case-type"]) && around s (place p)]
      where
        isOverlap = "Overlapping instances" `Text.isPrefixOf` withoutCode (ghc p)
    -- "‘a0’ is an ambiguous type variable" in the one, "(The choice depends on the instantiation of ‘a0’" in the other: GHC 9.6 places it at the function.
    names q p = Text.takeWhileEnd (/= '‘') (fst (Text.breakOn "’ is an ambiguous type variable" (ghc q))) `elem` Text.split (not . isAlphaNum) (snd (Text.breakOn "instantiation of" (ghc p)))
    -- Without the code of GHC 9.6 and newer, see 'original'.
    withoutCode said = maybe said (Text.drop 2 . Text.dropWhile (/= ']')) (Text.stripPrefix "[GHC-" said)
    around s = maybe False (\outer -> start outer <= start s && end s <= end outer)
    -- The robot of 2021 before the controller: without it simulate has one argument.
    isRobot q = any ((== tr "Remove the robot") . title) (fixes q)
    sameLine p q = fmap (line . start) (place p) == fmap (line . start) (place q)

-- | Explains one message.
explain :: ProgramOutline -> CompilerMessage -> Problem
explain outline raw = case category raw of
  Syntax -> explainSyntax (text outline) (messageCode raw) said (messageSpan raw)
  Tabs -> problem "tab" (tr "There is a tab in the program.") (tr "Use spaces: a tab is not equally wide everywhere.")
  Hole -> hole
  Scope -> notInScope
  IncompletePatterns -> uncurry (problem "missing-cases") (explainMissingCases outline raw)
  OverlappingPatterns -> problem "unreachable" (tr "This case is never reached.") (tr "The cases above it take everything already.")
  MissingFields -> problem "missing-field" (tr "A value is missing in this record.") (maybe (tr "Give it a value too.") (\f -> trWith "Give it a value too: {field}" ["field" =: f]) (listToMaybe (drop 1 (quotedParts said))))
  MissingMethods -> problem "missing-method" (tr "This instance is not complete.") (trWith "Define {or names} as well." ["names" =* quotedParts said])
  Other -> problem "other" (tr "The compiler has a remark about this.") (tr "Its own words are one click away.")
  Types -> fromMaybe unknown (listToMaybe (catMaybes [shape, explainTypes outline raw]))
  where
    said = oneLine (Text.unwords (important raw))
    everything = oneLine (Text.unwords (important raw ++ context raw ++ supplementary raw))
    problem k m h = Problem (messageSeverity raw) k (messageSpan raw) Nothing m h "" []
    names = quotedParts said
    firstName = fromMaybe "this" (listToMaybe names)
    saying t = t `Text.isInfixOf` said
    -- By GHC's code where the message has one; by its prose where it has none, as in GHC 9.0.
    states number t = maybe (saying t) (== number) (messageCode raw)
    unknown = problem "other" (tr "The compiler does not accept this.") (tr "Its own words are one click away.")

    hole = problem "hole" (tr "Something is missing here.") (whatFits raw)

    notImported = case (finding raw, qualifier) of
      (Just (ModuleNotImported q), _) -> Just q
      -- GHC 9.4 leaves out the qualifier, and that its module is not imported.
      (Nothing, Just q) | saying "Variable not in scope", not (imports q) -> Just q
      _ -> Nothing
    imports q = or [q `elem` ws | "import" : ws <- map Text.words (Text.lines (text outline))]
    -- Of the unknown name, as the program has it.
    qualifier = Text.stripSuffix ("." <> nameAlone) =<< snippet (text outline) =<< messageSpan raw
    moduleNotImported q = problem "not-in-scope" (trWith "‘{module}’ is not imported." ["module" =: q]) (importHint q)

    notInScope
      | Just q <- notImported = moduleNotImported q
      | Just advice <- unitHint unknownName, endsInNumber before = problem "unit" (tr "A number is written without its unit.") advice
      | behindDot = problem "operator" (tr "A value has no parts after a dot.") (tr "Take it apart with a pattern, for example: (Position x y)")
      | Text.isPrefixOf "(" unknownName = problem "operator" (trWith "There is no sign ‘{sign}’." ["sign" =: sign]) (fromMaybe (nearMiss everything sign) (foreignNameHint sign))
      | otherwise = problem "not-in-scope" (trWith "There is nothing called ‘{name}’." ["name" =: unknownName]) (fromMaybe (nearMiss everything unknownName) (foreignNameHint unknownName))
    endsInNumber = maybe False (isDigit . snd) . Text.unsnoc . Text.stripEnd
    nameAlone = Text.takeWhile (/= ' ') (fromMaybe "?" (after "not in scope: " said))
    unknownName = maybe nameAlone (<> "." <> nameAlone) qualifier
    sign = Text.dropAround (`elem` ("()" :: String)) unknownName
    before = maybe "" (\s -> Text.take (column (start s) - 1) (lineOf s)) (messageSpan raw)
    lineOf s = fromMaybe "" (listToMaybe (drop (line (start s) - 1) (Text.lines (text outline))))
    lastWord = maybe "" (Text.dropWhile (== '(')) . listToMaybe . reverse . Text.words
    -- As in p.x: the dot touches both.
    behindDot = case Text.unsnoc before of
      Just (rest, '.') | Just (_, c) <- Text.unsnoc rest -> isAlphaNum c || c == ')'
      _ -> False

    -- Messages without types.
    shape
      | Just q <- notImported = Just (moduleNotImported q)
      | Just rest <- after "Not in scope: " said = Just (undefinedThing rest)
      | saying "not in scope:" = Just notInScope
      | states 29916 "Multiple declarations of" || states 10498 "Conflicting definitions for" = Just (problem "duplicate" (trWith "‘{name}’ is defined twice." ["name" =: firstName]) (otherPlace (tr "Rename one of them, or put equations of the same function next to each other.")))
      | states 31744 "Duplicate type signatures" = Just (problem "duplicate" (trWith "‘{name}’ has two types." ["name" =: firstName]) (tr "Remove one of them."))
      | states 44432 "lacks an accompanying binding" = Just (problem "missing-definition" (trWith "‘{name}’ has a type but no definition." ["name" =: firstName]) (lacking everything))
      | states 91938 "different numbers of arguments" = Just (problem "argument-count" (trWith "The equations of ‘{name}’ take different numbers of values." ["name" =: firstName]) (if any looseParts (maybe [] (\r -> take (line (end r) - line (start r) + 1) (drop (line (start r) - 1) (Text.lines (text outline)))) (messageSpan raw)) then tr "A pattern with parts needs brackets, for example: (Bumper _ Pressed)" else tr "Give each of them the same number of patterns: _ stands for anything."))
      | states 87543 "Ambiguous occurrence" = Just (problem "ambiguous-name" (trWith "‘{name}’ is the name of two things." ["name" =: firstName]) (whichOne firstName everything))
      | states 55814 "The last statement in a 'do' block" = Just (problem "incomplete" (tr "A do block cannot end like this.") (tr "Its last line says what to do: add one."))
      | saying "Empty 'do' block" = Just (problem "incomplete" (tr "Nothing follows this ‘do’.") (tr "Write what to do on the next line, indented."))
      | firstName `elem` ["Left", "Right"], Just side <- lookup (lastWord before) [("Bumper", "BumperSide"), ("Cliff", "CliffSide"), ("Wheel", "WheelSide")], saying "but has been given none" = Just (problem "type-mismatch" (trWith "This is {a given}, but {a needed} is needed here." ["given" =: "Either a b", "needed" =: side]) (mismatchHint side "Either a b"))
      | saying "should have" && saying "arguments, but has been given" || saying "should have" && saying "argument, but has been given" = Just (patternArguments firstName)
      | saying "does not have the required strict field" = Just (problem "missing-field" (trWith "This ‘{name}’ is not complete." ["name" =: firstName]) (trWith "Write it as ‘{name}’ and its values in order." ["name" =: firstName]))
      | saying "does not have field" = Just (problem "unknown-field" (maybe (trWith "‘{name}’ has no field called that." ["name" =: firstName]) (\f -> trWith "‘{name}’ has no field called ‘{field}’." ["name" =: firstName, "field" =: f]) (listToMaybe (drop 1 names))) (trWith "Write it as ‘{name}’ and its values in order." ["name" =: firstName]))
      | saying "is not a (visible) field" || saying "is not a record selector" = Just (problem "unknown-field" (trWith "‘{name}’ is not a field." ["name" =: firstName]) (fromMaybe (tr "Write the constructor and its values in order.") (originalOptionsHint before)))
      | saying "cannot mix" = Just (problem "operator" (tr "Two comparisons cannot follow one another.") (if any (`elem` ["and", "or"]) (Text.words (fromMaybe "" (messageSpan raw >>= snippet (text outline)))) then tr "In Haskell, and is written &&, or is written ||." else tr "Join them with &&: 3 < s && s < 5"))
      | Just ('\'', _) <- Text.uncons =<< (messageSpan raw >>= snippet (text outline)) = Just (problem "character" (tr "Single quotation marks are for one letter.") (tr "A text is written between double ones: \"hello\""))
      | saying "Expecting" && saying "more argument" = Just (problem "type-argument" (trWith "‘{name}’ needs another type beside it." ["name" =: firstName]) ofWhat)
      | saying "Expected kind" && saying "but", typeHead (fromMaybe "" (listToMaybe (drop 1 names))) == "Task" = Just (problem "type-argument" (tr "‘Task’ takes one type: what the task ends with.") (tr "Remove the first of the two, for example: Task ()"))
      | saying "Expected kind" && saying "but" = Just (problem "type-argument" (trWith "‘{type}’ is a complete type: nothing can follow it." ["type" =: typeHead (fromMaybe "" (listToMaybe (drop 1 names)))]) (tr "Remove what comes after it, or put an arrow -> between."))
      | saying "Expected a type, but" || saying "Expected a constraint" = Just (problem "type-argument" (trWith "‘{name}’ cannot be used in this place of a type." ["name" =: firstName]) (if maybe False (Text.isInfixOf "=>" . lineOf) (messageSpan raw) then tr "An arrow -> goes between what a function takes and what it gives." else tr "Check the type for a missing arrow or bracket."))
      | saying "Parse error in pattern" || saying "Pattern syntax in expression" = Just (problem "pattern" (tr "This cannot be on the left of an equals sign.") (tr "Write names, constructors and _ there, each with brackets around it if it has parts."))
      | saying "Illegal" || saying "Perhaps you intended to use" || saying "Perhaps you meant to use" = Just (problem "extension" (tr "This needs a language extension that is not switched on.") (tr "There is nearly always a simpler way to say it."))
      | states 54721 "method of class" = Just (problem "unknown-method" (maybe (trWith "This class has nothing called ‘{name}’." ["name" =: firstName]) (\c -> trWith "‘{class}’ has nothing called ‘{name}’." ["class" =: c, "name" =: firstName]) (listToMaybe (drop 1 names))) (tr "Write one of the names that are in the class."))
      | states 23517 "newtype must have exactly one" = Just (problem "newtype" (tr "A newtype holds exactly one value.") (tr "For more than one, write data."))
      | saying "No explicit implementation" = Just (problem "missing-method" (tr "This instance is not complete.") (tr "Define its functions as well."))
      | states 59692 "Duplicate instance declarations",
        (c, t) : _ <- [(c, t) | c <- ["Sensor", "Command"], Just t <- [between ("instance " <> c <> " ") " -- Defined in ‘Rosy." said]] =
        Just (problem "duplicate" (if c == "Sensor" then trWith "The robot has a sensor ‘{type}’ already." ["type" =: t] else trWith "The robot has a command ‘{type}’ already." ["type" =: t]) (trWith "Remove this declaration. For a topic of your own declare a type: newtype My{type} = My{type} {type}" ["type" =: t]))
      | states 59692 "Duplicate instance declarations" = Just (problem "duplicate" (tr "Rosy has done this for you already.") (tr "Remove this declaration."))
      | saying "does not export" = Just (problem "not-in-scope" (maybe (trWith "The module ‘{module}’ has no such name." ["module" =: firstName]) (\n -> trWith "The module ‘{module}’ has no ‘{name}’." ["module" =: firstName, "name" =: n]) (listToMaybe (drop 1 names))) (tr "Check its spelling."))
      | saying "Could not find module" || saying "Could not load module" = Just (problem "import" (trWith "The module ‘{module}’ is not available here." ["module" =: firstName]) (tr "Remove this import."))
      | otherwise = Nothing

    undefinedThing rest
      | Just advice <- unitHint firstName, endsInNumber before = problem "unit" (tr "A number is written without its unit.") advice
      | finding raw == Just ConstructorAsType || "data constructor of that name" `Text.isInfixOf` Text.unwords [said, everything] = problem "not-a-type" (trWith "‘{name}’ is a value, not a type." ["name" =: firstName]) (fromMaybe (tr "In a type, write the type that it belongs to.") (typeOfValue firstName))
      | "type variable" `Text.isPrefixOf` rest = problem "not-in-scope" (trWith "There is no type called ‘{name}’." ["name" =: firstName]) (tr "Types begin with capital letters, for example: Turn Double")
      | any (`Text.isInfixOf` everything) ["No module named", "no module named"],
        module_ <- fromMaybe "" (listToMaybe (drop 1 names)) =
        moduleNotImported module_
      | "type constructor or class" `Text.isPrefixOf` rest = problem "not-in-scope" (trWith "There is no type called ‘{name}’." ["name" =: firstName]) (fromMaybe (if amongValues then tr "If it is one more value of this type, write | in front of it." else nearMiss everything firstName) (foreignNameHint firstName))
      | otherwise = problem "not-in-scope" (trWith "There is nothing called ‘{name}’." ["name" =: firstName]) (fromMaybe (nearMiss everything firstName) (originalOptionsHint before <|> foreignNameHint firstName))

    -- As in: data Mode = Go Stop
    amongValues = null (nearMisses everything firstName) && "data" `elem` take 1 (Text.words (maybe "" lineOf (messageSpan raw))) && "=" `Text.isInfixOf` before

    patternArguments c =
      let counts = mapMaybe readNumber (Text.words (fromMaybe "" (after "should have" said)))
       in case counts of
            1 : 0 : _ -> problem "pattern-arguments" (trWith "‘{name}’ holds one value, but here none are named." ["name" =: c]) (withParts c 1)
            wanted : 0 : _ -> problem "pattern-arguments" (trWith "‘{name}’ holds {count wanted} values, but here none are named." ["name" =: c, "wanted" =# wanted]) (withParts c wanted)
            1 : given : _ -> problem "pattern-arguments" (trWith "‘{name}’ holds one value, but here {count given} are named." ["name" =: c, "given" =# given]) nameEach
            wanted : 1 : _ -> problem "pattern-arguments" (trWith "‘{name}’ holds {count wanted} values, but here one is named." ["name" =: c, "wanted" =# wanted]) nameEach
            wanted : given : _ -> problem "pattern-arguments" (trWith "‘{name}’ holds {count wanted} values, but here {count given} are named." ["name" =: c, "wanted" =# wanted, "given" =# given]) nameEach
            _ -> problem "pattern-arguments" (trWith "‘{name}’ does not hold that many values." ["name" =: c]) nameEach
    withParts c wanted = trWith "Write it with its parts in brackets: ({code})" ["code" =: Text.unwords (c : replicate wanted "_")]
    nameEach = tr "Name each of them: _ stands for one that is not needed."

    -- The hint for a type without the one that it is about.
    ofWhat
      | firstName == "Memory" = trWith "Say what is remembered, for example: {example}" ["example" =: exampleOf firstName]
      | firstName `elem` ["Task", "Done"] = trWith "Say with what it ends, for example: {example}" ["example" =: exampleOf firstName]
      | otherwise = trWith "Say of what, for example: {example}" ["example" =: exampleOf firstName]

    otherPlace advice = case nub (mapMaybe lineIn (filter ("Main.hs:" `Text.isPrefixOf`) (Text.words said))) of
      l : _ | Just l /= fmap (line . start) (messageSpan raw) -> trWith "The other is in line {line}: remove or rename one of them." ["line" =# l]
      _ -> advice
    lineIn w = readNumber (Text.takeWhile (/= ':') (Text.drop (Text.length "Main.hs:") w))

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

lacking :: Text -> Sentence
lacking everything = case maybe [] quotedParts (after "Perhaps you meant" everything) of
  x : _ -> trWith "Did you mean {or names}?" ["names" =* [x]]
  [] -> tr "Write an equation for it below its type."

importHint :: Text -> Sentence
importHint q = case moduleForAlias q of
  Just m -> trWith "Write at the top: import qualified {module} as {alias}" ["module" =: m, "alias" =: q]
  Nothing -> tr "Import the module, or leave out what comes before the dot."
