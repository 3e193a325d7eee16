{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Explanation.MissingCases
-- Description : Explanation of missing cases: patterns that no equation has, and guards without a last case.
--
-- GHC lists the patterns that are not matched. They are compared with the patterns of each equation or alternative in the text: where one of
-- them covers a listed pattern and ends without @otherwise@, the guards are what is incomplete.
module Rosy.Worker.Explanation.MissingCases
  ( explainMissingCases,
    unmatchedPatterns,
    functionWithEquations,
    OpenGuards (..),
    openGuards,
  )
where

import Data.Char (isUpper)
import Data.List (find)
import Data.Maybe (fromMaybe, isJust, listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.CompilerMessage
import Rosy.Worker.Explanation.MessageText
import Rosy.Worker.Explanation.Tokenizer
import Rosy.Worker.Problem
import Rosy.Worker.Sentence

-- | The message and the hint.
explainMissingCases :: ProgramOutline -> CompilerMessage -> (Sentence, Sentence)
explainMissingCases outline raw = (message', hint')
  where
    message' = maybe (tr "This says nothing about some cases.") (\f -> trWith "‘{function}’ says nothing about some cases." ["function" =: f]) (functionWithEquations raw)
    missing = unmatchedPatterns raw
    more = length missing - 1
    hint' = case openGuards outline raw of
      Just g | isOnly g -> trWith "Add a last line: | otherwise {sign} …" ["sign" =: separator g]
      Just g -> trWith "Add a last guard after ‘{guard}’: | otherwise {sign} …" ["guard" =: lastGuard g, "sign" =: separator g]
      Nothing -> case missing of
        [] -> tr "Add an equation for what is left."
        m : _
          | more > 0 -> trWith "Add one for ‘{pattern}’, and for {count more} more." ["pattern" =: plainPattern m, "more" =# more]
          | otherwise -> trWith "Add one for ‘{pattern}’." ["pattern" =: plainPattern m]

-- | The patterns that GHC lists.
unmatchedPatterns :: CompilerMessage -> [Text]
unmatchedPatterns raw = maybe [] (filter (not . Text.null) . map Text.strip . Text.lines) (after "Patterns not matched:" (Text.unlines (important raw)))

-- | The function whose equations are incomplete; nothing for a @case@ or a @\\case@.
functionWithEquations :: CompilerMessage -> Maybe Text
functionWithEquations raw = between "equation for ‘" "’" (oneLine (Text.unwords (important raw)))

-- | Guards of one equation or alternative, none of which is @otherwise@.
data OpenGuards = OpenGuards
  { -- | The last guard as written.
    lastGuard :: Text,
    -- | What stands between a guard and its value.
    separator :: Text,
    -- | Where one more guard can be inserted, and its column.
    endOfGuards :: Position,
    guardColumn :: Int,
    -- | Whether the function or @case@ has no other equation or alternative.
    isOnly :: Bool
  }

-- | The first guards without a last case that a missing pattern reaches.
openGuards :: ProgramOutline -> CompilerMessage -> Maybe OpenGuards
openGuards outline raw = do
  s <- messageSpan raw
  let inside = [t | t <- tokenize (text outline), from t >= start s, from t < end s]
      branches = case functionWithEquations raw of
        Just f -> map (drop 1) (splitBefore (\t -> word t == f && column (from t) == column (start s)) inside)
        Nothing | isMultiWayIf -> [dropWhile ((/= "|") . word) inside]
        Nothing -> alternatives inside
      reached = [g | branch <- branches, isMultiWayIf || null missing || any (overlaps (patterns (takeWhile (not . isEnd) branch))) missing, Just g <- [guardsOf branch]]
  g <- listToMaybe reached
  Just g {isOnly = length branches == 1}
  where
    isMultiWayIf = "multi-way if" `Text.isInfixOf` Text.unwords (important raw)
    missing = map (patterns . tokenize) (unmatchedPatterns raw)
    guardsOf branch = do
      let signs = outer (takeWhile ((/= "where") . word) branch)
          bars = [t | t <- signs, word t == "|"]
      bar <- listToMaybe (reverse bars)
      -- The first sign that ends the patterns is a bar.
      if (word <$> find isEnd signs) == Just "|" then Just () else Nothing
      let behind = takeWhile ((/= "where") . word) (dropWhile ((<= from bar) . from) branch)
          guardTokens = takeWhile ((`notElem` ["=", "->"]) . word) behind
      close <- find ((`elem` ["=", "->"]) . word) behind
      final <- listToMaybe (reverse behind)
      if any isLast (concatMap (takeWhile ((`notElem` ["=", "->"]) . word)) (splitBefore ((== "|") . word) signs)) || null guardTokens
        then Nothing
        else
          Just
            OpenGuards
              { lastGuard = oneLine (textAt (text outline) (Span (from bar) (tokenEnd (last guardTokens)))),
                separator = word close,
                endOfGuards = closed (text outline) final,
                guardColumn = if isFirstOnLine bar then column (from bar) else maybe 1 (column . from) (listToMaybe branch) + 2,
                isOnly = False
              }
    isLast t = word t `elem` ["otherwise", "True"]
    isFirstOnLine t = Text.null (Text.strip (Text.take (column (from t) - 1) (lineOf (text outline) (line (from t)))))

-- | The end of a token; a string literal is a token without its contents.
closed :: Text -> Token -> Position
closed source t
  | word t `elem` ["\"", "'"] = (from t) {column = Text.length (Text.stripEnd (lineOf source (line (from t)))) + 1}
  | otherwise = tokenEnd t

-- | The alternatives of a @case@ or a @\\case@: what begins in the column of the first of them.
alternatives :: [Token] -> [[Token]]
alternatives tokens = case dropWhile ((/= "of") . word) tokens of
  _ : first : rest -> splitBefore (\t -> column (from t) == column (from first)) (first : rest)
  _ -> case drop 1 (dropWhile ((/= "case") . word) tokens) of
    first : rest -> splitBefore (\t -> column (from t) == column (from first)) (first : rest)
    [] -> []

-- | The parts that begin with such a token.
splitBefore :: (a -> Bool) -> [a] -> [[a]]
splitBefore begins xs = case break begins xs of
  (_, []) -> []
  (_, x : rest) -> let (part, others) = break begins rest in (x : part) : splitBefore begins others

-- | The tokens outside of brackets.
outer :: [Token] -> [Token]
outer = go (0 :: Int)
  where
    go _ [] = []
    go n (t : ts)
      | word t `elem` ["(", "[", "{"] = go (n + 1) ts
      | word t `elem` [")", "]", "}"] = go (max 0 (n - 1)) ts
      | n == 0 = t : go n ts
      | otherwise = go n ts

isEnd :: Token -> Bool
isEnd t = word t `elem` ["|", "=", "->"]

-- * Patterns

-- | A pattern as far as it decides whether it can match another one.
data Pattern
  = Anything
  | -- | A constructor, and its fields unless they are written in braces.
    Constructor Text (Maybe [Pattern])
  | Tuple [Pattern]

-- | The patterns that stand beside one another. The bare argument of an alternative is one constructor with its fields.
patterns :: [Token] -> [Pattern]
patterns tokens = case atoms tokens of
  [Constructor c (Just [])] -> [Constructor c (Just [])]
  Constructor c (Just []) : fields -> [Constructor c (Just fields)]
  ps -> ps

atoms :: [Token] -> [Pattern]
atoms tokens = case tokens of
  [] -> []
  t : rest
    | word t `elem` ["!", "~"] -> atoms rest
    | word t `elem` ["(", "["] ->
      let (inside, behind) = group (1 :: Int) rest
          parts = commaParts inside
       in (if word t == "[" || any ((== ":") . word) (outer inside) then Anything else if length parts == 1 then inBrackets (patterns inside) else Tuple (map (inBrackets . patterns) parts)) : atoms behind
    | at : more <- rest, word at == "@" -> atoms more
    | isUpper' (word t), b : more <- rest, word b == "{" -> Constructor (word t) Nothing : atoms (snd (group 1 more))
    | isUpper' (word t) -> Constructor (word t) (Just []) : atoms rest
    | otherwise -> Anything : atoms rest
  where
    isUpper' w = maybe False (isUpper . fst) (Text.uncons w)
    inBrackets ps = fromMaybe Anything (listToMaybe ps)

-- | Up to the closing bracket, and what follows it.
group :: Int -> [Token] -> ([Token], [Token])
group _ [] = ([], [])
group n (t : ts)
  | word t `elem` ["(", "[", "{"] = more (n + 1)
  | word t `elem` [")", "]", "}"] = if n == 1 then ([], ts) else more (n - 1)
  | otherwise = more n
  where
    more m = let (inside, behind) = group m ts in (t : inside, behind)

commaParts :: [Token] -> [[Token]]
commaParts tokens = case break isComma tokens of
  (part, _ : rest) -> part : commaParts rest
  (part, []) -> [part]
  where
    commas = [from t | t <- outer tokens, word t == ","]
    isComma t = from t `elem` commas

-- | Whether there may be a value that all of these patterns match.
overlaps :: [Pattern] -> [Pattern] -> Bool
overlaps ps qs = length ps /= length qs || and (zipWith both ps qs)
  where
    both p q = case (p, q) of
      (Constructor c fs, Constructor d gs) -> c == d && (not (isJust fs && isJust gs) || overlaps (fromMaybe [] fs) (fromMaybe [] gs))
      (Tuple fs, Tuple gs) -> overlaps fs gs
      _ -> True

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
