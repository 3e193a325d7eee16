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
import Data.Char (isAlphaNum)
import Data.Foldable (asum)
import Data.List (nubBy)
import Data.Maybe (fromMaybe, listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.CompilerMessage
import Rosy.Worker.Explanation.ConfusableCharacters (explainConfusable)
import Rosy.Worker.Explanation.DefinitionErrors (definitionErrors)
import Rosy.Worker.Explanation.EmptyPlaces (whatFits)
import qualified Rosy.Worker.Explanation.MessageParts as Parts
import Rosy.Worker.Explanation.MessageText
import Rosy.Worker.Explanation.MissingCases (explainMissingCases)
import Rosy.Worker.Explanation.NameErrors (nameErrors, notInScope)
import Rosy.Worker.Explanation.QuickFixes (quickFixes)
import Rosy.Worker.Explanation.SyntaxErrors (explainSyntax)
import Rosy.Worker.Explanation.TextRepair (Program (source, tokens), chunkOf, edited, isName, lineAfter, ownerOf, programOf)
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
    withoutCode messageText = maybe messageText (Text.drop 2 . Text.dropWhile (/= ']')) (Text.stripPrefix "[GHC-" messageText)
    around s = maybe False (\outer -> start outer <= start s && end s <= end outer)
    -- The robot of 2021 before the controller: without it simulate has one argument.
    isRobot q = any ((== tr "Remove the robot") . title) (fixes q)
    sameLine p q = fmap (line . start) (place p) == fmap (line . start) (place q)

-- | Explains one message.
explain :: ProgramOutline -> CompilerMessage -> Problem
explain outline raw = case category raw of
  Syntax -> explainSyntax (text outline) (messageCode raw) (Parts.messageText parts) (messageSpan raw)
  Tabs -> problem "tab" (tr "There is a tab in the program.") (tr "Use spaces: a tab is not equally wide everywhere.")
  Hole -> problem "hole" (tr "Something is missing here.") (whatFits raw)
  Scope -> notInScope parts
  IncompletePatterns -> uncurry (problem "missing-cases") (explainMissingCases outline raw)
  OverlappingPatterns -> problem "unreachable" (tr "This case is never reached.") (tr "The cases above it take everything already.")
  MissingFields -> problem "missing-field" (tr "A value is missing in this record.") (maybe (tr "Give it a value too.") (\f -> trWith "Give it a value too: {field}" ["field" =: f]) (listToMaybe (drop 1 (Parts.names parts))))
  MissingMethods -> problem "missing-method" (tr "This instance is not complete.") (trWith "Define {or names} as well." ["names" =* Parts.names parts])
  Other -> problem "other" (tr "The compiler has a remark about this.") (tr "Its own words are one click away.")
  Types -> fromMaybe (problem "other" (tr "The compiler does not accept this.") (tr "Its own words are one click away.")) (asum (map ($ parts) (nameErrors ++ definitionErrors)) <|> explainTypes outline raw)
  where
    parts = Parts.messageParts outline raw
    problem = Parts.problem parts
