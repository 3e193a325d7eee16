{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Explanation.TextualMistakes.Definitions
-- Description : Definitions and declarations with signs and words of other languages: braces, other equals signs, keywords, second values.
module Rosy.Worker.Explanation.TextualMistakes.Definitions
  ( braces,
    definitions,
    declarations,
    programStart,
    secondValues,
  )
where

import Data.List (tails)
import Data.Maybe (listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.Explanation.MessageText (textAt)
import Rosy.Worker.Explanation.RobotVocabulary (rememberedHint, robotNames)
import Rosy.Worker.Explanation.TextRepair
import Rosy.Worker.Explanation.Tokenizer
import Rosy.Worker.Problem
import Rosy.Worker.Sentence

-- | Braces around the body of a function or the parts of a condition.
braces :: Program -> [Problem]
braces p = concatMap (bracedFunction p) (rows p) ++ bracedConditions p

noBraces :: Sentence
noBraces = tr "Haskell has no braces around what belongs together."

-- | A function whose first line ends with an opening brace. It has a repair if its body is one line with one value.
bracedFunction :: Program -> [Token] -> [Problem]
bracedFunction p row =
  [ if isCertain then repaired p (tokenSpan opening) "syntax" (tr "What a function gives stands behind an equals sign, not in braces.") [Edit (spanOf opening closing) (equals <> value)] else repairedWith p (tokenSpan opening) "syntax" (tr "What a function gives stands behind an equals sign, not in braces.") (tr "Write = in place of the opening brace, and remove the closing one.") []
    | f : _ <- [row],
      column (from f) == 1,
      word f `notElem` ["data", "newtype", "type", "class", "instance", "module", "import"],
      opening : reversed <- [reverse row],
      word opening == "{",
      all ((`notElem` ["=", "::"]) . word) (drop 1 reversed),
      (body, closing : _) <- [break ((`elem` ["{", "}"]) . word) (drop 1 (dropWhile ((< from opening) . from) (tokens p)))],
      let values = takeWhile ((/= ";") . word) (dropWhile ((== "return") . word) body),
      let value = Text.strip (Text.dropWhileEnd (`elem` ("; \n\r" :: String)) (textAt (source p) (Span (maybe (from closing) from (listToMaybe values)) (from closing)))),
      let isCertain = word closing == "}" && isFunctionName f && not (any ((`elem` [",", "return"]) . word) (reversed ++ values)) && isOneValue (body, values) && not (any (`Text.isInfixOf` value) ["\n", "--", "{-"]),
      let equals = if map word (take 1 reversed) == ["="] then "" else "= "
  ]
  where
    isFunctionName f = isName (word f) && word f `notElem` ["function", "def", "func", "fun", "void", "int"]
    -- With a semicolon behind it, perhaps.
    isOneValue (body, values) = not (null values) && length body - length (takeWhile ((== "return") . word) body) - length values <= 1

bracedConditions :: Program -> [Problem]
bracedConditions p =
  [ repairedWith p (spanOf o c) "syntax" noBraces hint' [Edit (tokenSpan o) "then", Edit (tokenSpan c) "", Edit (tokenSpan q) "", Edit (tokenSpan z) ""]
    | i : more <- tails (tokens p),
      word i == "if",
      (_, o : rest) <- [break ((== "{") . word) more],
      (first, c : e : q : others) <- [break ((== "}") . word) rest],
      word e == "else",
      word q == "{",
      (second, z : _) <- [break ((== "}") . word) others],
      all ((`notElem` ["if", "{", "=", ";", "return"]) . word) (first ++ second)
  ]
  where
    hint' = tr "Write: if condition then one value else another."

-- | Definitions with another sign than the equals sign, and types with another sign than two colons.
definitions :: Program -> [Problem]
definitions p = concatMap concat [inRows splitSigns, inRows functionValues, inRows hatBlocks, inRows returnedValues, inRows equalsSigns, inRows typeSynonyms, inRows dataTypes, inRows signatures, inRows functionArrows, inRows colons, inRows missingEquals]
  where
    inRows rule = map (rule p) (rows p)

-- | A token of a definition, and what replaces it.
definition :: Program -> Token -> Sentence -> Text -> Problem
definition p t message' new = repaired p (tokenSpan t) "definition" message' [Edit (tokenSpan t) new]

equalsSigns :: Program -> [Token] -> [Problem]
equalsSigns p row =
  [ definition p t (tr "A name gets its value with an equals sign.") "="
    | (before@(f : _), t : _) <- [break ((`elem` ["=", "<-", ":=", "|", "::", "->"]) . word) row],
      word t == ":=" && word f /= "main" || word t == "<-" && (column (from f) == 1 || word f == "where"),
      all ((/= "do") . word) before
  ]

-- | A sign of two characters with a space between them: @- >@.
splitSigns :: Program -> [Token] -> [Problem]
splitSigns p row =
  [ repaired p (spanOf a b) "operator" (trWith "‘{sign}’ is one sign, without a space in it." ["sign" =: whole]) [Edit (spanOf a b) whole]
    | (a, b, behind) <- zip3 row (drop 1 row) (drop 2 (map Just row) ++ [Nothing]),
      let whole = word a <> word b,
      whole `elem` ["->", "<-", "==", "/=", "<=", ">=", "&&", "||", "::", "++"],
      not (isGlued a b),
      -- x < -5
      whole /= "<-" || maybe True (not . isGlued b) behind
  ]

-- | A definition whose parameters stand behind the equals sign, as other languages write a function: @f = (x) => y@ and @f = lambda x: y@.
functionValues :: Program -> [Token] -> [Problem]
functionValues p row =
  [ repaired p (Span (from f) (tokenEnd arrow)) "definition" (tr "What a function takes stands in front of the equals sign.") [Edit (Span (from f) (from body)) (Text.unwords (word f : parameters) <> " = ")]
    | f : e : rest <- [row],
      column (from f) == 1,
      isName (word f),
      word e == "=",
      (sign, begin) <- [case rest of t : more | word t == "lambda" -> (":", more); _ -> ("=>", rest)],
      (names, arrow : body : _) <- [break ((== sign) . word) begin],
      all (\t -> isName (word t) || word t `elem` ["(", ")", ",", "_"]) names,
      word body /= "{",
      let found = [word t | t <- names, word t `notElem` ["(", ")", ","]],
      let parameters = if null found then ["()"] else found
  ]

-- | A block of another language that says when something is done: @when Bumper Pressed:@ at the left edge.
hatBlocks :: Program -> [Token] -> [Problem]
hatBlocks p row =
  [ repairedWith p (spanOf w c) "definition" (tr "What the robot does when something happens is a function.") (trWith "Write, for example: {code}" ["code" =: "hit (Bumper _ Pressed) = Velocity 0 0"]) []
    | w : _ : _ <- [row],
      column (from w) == 1,
      word w `elem` ["when", "whenever", "on", "if"],
      c : _ <- [reverse row],
      word c `elem` [":", "do", "{"],
      all ((`notElem` ["=", "::"]) . word) row
  ]

-- | @return@ in front of what a function gives that is no task. Takes the row where its type stands.
returnedValues :: Program -> [Token] -> [Problem]
returnedValues p row =
  [ repaired p (tokenSpan r) "type-mismatch" (trWith "A function gives its value without ‘{word}’." ["word" =: word r]) [Edit (Span (from x) (from v)) "" | (x, v) <- found]
    | f : c : types <- [row],
      column (from f) == 1,
      word c == "::",
      result : _ <- [reverse (splitOnArrows types)],
      all ((`notElem` ["Task", "IO"]) . word) result,
      all (isConstructor . word) (take 1 result),
      found@((r, _) : _) <- [[(x, v) | (e, x, v) <- zip3 (tokens p) (drop 1 (tokens p)) (drop 2 (tokens p)), word e `elem` ["=", "then", "else"], word x == "return", line (from v) == line (from x), isWrapped v == isOptional result, ownerOf p (line (from x)) == Just (word f)]]
  ]
  where
    -- What may be missing can be given with return as well.
    isOptional result = map word (take 1 result) `elem` [["Maybe"], ["Either"]]
    isWrapped v = word v `elem` ["Just", "Nothing", "Left", "Right"]
    splitOnArrows ts = case break ((== "->") . word) ts of
      (first, _ : more) -> first : splitOnArrows more
      (first, []) -> [first]

typeSynonyms :: Program -> [Token] -> [Problem]
typeSynonyms p row = case row of
  d : n : t : _ | word d == "type", isConstructor (word n), word t `elem` ["::", ":", ":="] -> [definition p t message' "="]
  d : t : n : more | word d == "type", word t == "::", "=" `elem` map word more -> [repaired p (tokenSpan t) "definition" message' [Edit (Span (from t) (from n)) ""]]
  _ -> []
  where
    message' = tr "‘type’ gives a type another name with an equals sign."

dataTypes :: Program -> [Token] -> [Problem]
dataTypes p row = case row of
  d : n : t : _ | word d == "data", isConstructor (word n), word t `elem` ["::", ":", ":="] -> [definition p t (tr "The values of a type come after an equals sign.") "="]
  _ -> []

-- | @f = Bumper -> Velocity@, where a signature is meant.
signatures :: Program -> [Token] -> [Problem]
signatures p row =
  [ repaired p (tokenSpan t) "missing-colon" (tr "Two colons go between a name and its type.") [Edit (tokenSpan t) "::"]
    | f : t : types <- [row],
      column (from f) == 1,
      isName (word f),
      word t == "=",
      "->" `elem` map word types,
      all (\x -> isConstructor (word x) || word x `elem` ["->", "(", ")", "[", "]", ",", "()"]) types
  ]

functionArrows :: Program -> [Token] -> [Problem]
functionArrows p row =
  [ repaired p (tokenSpan t) "missing-arrow" (tr "An arrow -> goes between what a function takes and what it gives.") [Edit (tokenSpan t) "->"]
    | (_, _ : types) <- [break ((== "::") . word) row],
      (before, t : _) <- [break ((== "=>") . word) types],
      all (\x -> word x `elem` ["(", ")", "->"] || word x `elem` robotNames) before
  ]

-- | Colons that another language has behind a word.
colons :: Program -> [Token] -> [Problem]
colons p row =
  [ repaired p (tokenSpan c) "syntax" (trWith "There is no colon after ‘{word}’." ["word" =: word k]) [Edit (tokenSpan c) ""]
    | k : c : _ <- tails row,
      word k `elem` ["do", "where", "then", "else", "of"],
      word c == ":"
  ]
    ++ [ repaired p (tokenSpan c) "missing-then" (tr "After ‘if’ and its condition comes ‘then’, without a colon.") [Edit (tokenSpan c) " then"]
         | (_, _ : _ : condition) <- [break ((== "if") . word) row],
           c : _ <- [reverse condition],
           word c == ":",
           all ((`notElem` ["then", "="]) . word) condition
       ]

missingEquals :: Program -> [Token] -> [Problem]
missingEquals p row = case row of
  [k, n, v] | word k `elem` ["where", "let"], isName (word n), isNumeral (word v) -> [insertedEquals p (spanOf n v) n]
  _ -> []

-- | Inserts an equals sign behind a token.
insertedEquals :: Program -> Span -> Token -> Problem
insertedEquals p s t = repaired p s "missing-equals" (tr "Here an equals sign is missing.") [Edit (nothingAt (tokenEnd t)) " ="]

-- | Definitions and declarations that begin with a word of another language.
declarations :: Program -> [Problem]
declarations p = concatMap variable (rows p) ++ concatMap enumeration (rows p) ++ concatMap assignment (rows p)
  where
    variable row = case row of
      k : t : n : e : _ | word k `elem` ["where", "let"], word t `elem` variableKeywords, isName (word n), word e == "=" -> [withoutWord t n]
      t : n : e : _
        | word t `elem` variableKeywords || word t == "let" && column (from t) == 1,
          isName (word n),
          word e == "=" ->
          [if isStep p t then repaired p (tokenSpan t) "definition" (trWith "In a ‘do’, a value gets its name with ‘let’, not with ‘{word}’." ["word" =: word t]) [Edit (tokenSpan t) "let"] else withoutWord t n]
      _ -> []
    withoutWord t n = repaired p (tokenSpan t) "definition" (trWith "A definition begins with its name: ‘{word}’ does not belong there." ["word" =: word t]) [Edit (Span (from t) (from n)) ""]
    enumeration row = case row of
      t : n : e : more
        | word t `elem` ["enum", "struct"],
          isConstructor (word n),
          word e == "=",
          "|" `elem` map word more || length more == 1 ->
          [definition p t (trWith "‘{word}’ means nothing in Haskell." ["word" =: word t]) "data"]
      _ -> []
    assignment row = case row of
      [n, a, v]
        | column (from n) > 1,
          isName (word n),
          word a == "<-",
          isNumeral (word v) ->
          [repaired p (tokenSpan n) "definition" (tr "In a ‘do’, a value gets its name with ‘let’ and an equals sign.") [Edit (spanOf n a) ("let " <> word n <> " =")]]
      _ -> []

-- | Whether a token begins a step of a @do@, and no definition at the left edge or behind @where@ or @let@.
isStep :: Program -> Token -> Bool
isStep p t = column (from t) > 1 && not (isOfDefinitions outer)
  where
    -- The nearest line above that is further to the left.
    outer = take 1 (reverse [row | row@(f : _) <- rows p, line (from f) < line (from t), column (from f) < column (from t)])
    isOfDefinitions found = or [word l /= "do" && any ((`elem` ["where", "let"]) . word) [f, l] | row@(f : _) <- found, l : _ <- [reverse row]]

-- | Words in front of a variable in other languages.
variableKeywords :: [Text]
variableKeywords = Text.words "var const val int double float bool boolean string String Int Integer Double Float Bool char auto local final static set number"

-- | Where the program starts.
programStart :: Program -> [Problem]
programStart p = concat [wrongName, withoutName, withoutEquals, startedAgain, moduleName]
  where
    atLeftEdge = [row | row@(f : _) <- rows p, column (from f) == 1]
    hasMain = or [Text.toLower (word f) == "main" | f : _ <- atLeftEdge]
    noMain = tr "A program starts at ‘main’, and this one has none."
    wrongName =
      [ repaired p (tokenSpan f) "main-type" noMain [Edit (tokenSpan f) "main"]
        | not hasMain,
          [f] <- [[f | f : e : s : _ <- atLeftEdge, isName (word f), word e == "=", word s == "simulate"]]
      ]
    withoutName =
      [ repaired p (tokenSpan s) "main-type" noMain [Edit (nothingAt (from s)) "main = "]
        | not hasMain,
          [s] <- [[s | s : _ <- atLeftEdge, word s == "simulate"]]
      ]
    withoutEquals = [insertedEquals p (tokenSpan m) m | m : s : _ <- rows p, word m == "main", word s == "simulate"]
    startedAgain =
      [ repairedWith p (spanOf m (lastOf m row)) "syntax" (tr "‘main’ starts by itself.") (tr "Remove this line.") [linesRemoved (line (from m)) (line (from m))]
        | row@(m : _) <- atLeftEdge,
          map word row `elem` [["main"], ["main", "(", ")"]],
          or [word n == "main" && word e == "=" | n : e : _ <- atLeftEdge]
      ]
    lastOf = foldl (\_ t -> t)
    moduleName =
      [ repaired p (tokenSpan m) "capital" (tr "The names of modules begin with capital letters.") [Edit (tokenSpan m) (capitalised (word m))]
        | k : m : w : _ <- rows p,
          word k == "module",
          isName (word m),
          word w `elem` ["where", "("]
      ]

-- | A second value for a name, as if it changed.
secondValues :: Program -> [Problem]
secondValues p =
  [ repairedWith p (tokenSpan n) "duplicate" message' (rememberedHint (word n)) []
    | (before, n : e : value) <- zip (scanl (flip (:)) [] (rows p)) (rows p),
      column (from n) == 1,
      isName (word n),
      word n /= "main",
      word e == "=",
      word n `elem` map word value || all (isNumeral . word) value,
      or [word m == word n && word d == "=" | m : d : _ <- before],
      let message' = trWith "‘{name}’ has a value already, and keeps it." ["name" =: word n]
  ]
