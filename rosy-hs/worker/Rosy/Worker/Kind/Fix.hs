{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Kind.Fix
-- Description : How a problem can be mended, as pieces of text to replace.
--
-- Takes a problem that has its kind, its place and its words already, the program, and what the compiler said besides. A fix that would need a guess at what
-- the author means is not offered; where a value is still to be chosen it puts a hole, @_@. Pure.
module Rosy.Worker.Kind.Fix
  ( fixesFor,
    nearMisses,
  )
where

import Data.Char (isAlphaNum, isSpace)
import Data.List (find)
import Data.Maybe (fromMaybe, listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.Kind.Imports (importFor, moduleOf)
import Rosy.Worker.Kind.Nouns (loops, spelling)
import Rosy.Worker.Kind.Tokens (Token (..), scan, upTo)
import Rosy.Worker.Kind.Words
import Rosy.Worker.Problem
import Rosy.Worker.Raw

-- | The ways to mend a problem, the likeliest first.
fixesFor :: Outline -> Raw -> Problem -> [Fix]
fixesFor outline raw p = case (kind p, place p) of
  ("not-in-scope", Just s) -> map (spelled s) (take 3 (maybe (if textAt source s `elem` loops then [] else nearMisses everything (textAt source s)) pure (spelling (textAt source s)))) ++ imports s
  ("missing-definition", Just s) -> map (spelled s) (take 1 (nearMisses everything (textAt source s))) ++ equation s
  ("hole", Just s) -> [Fix ("Fill in " <> n) [Edit s n] | n <- fitting]
  ("missing-cases", Just s) -> cases s
  ("bracket", Just s) -> bracket s
  ("missing-quote", Just s) -> [Fix "Close the text" [Edit (nothingAt (end s)) "\""]]
  ("missing-just", Just s) -> [Fix "Write Just in front" [Edit s ("Just " <> bracketed (textAt source s))]]
  ("negative-number", Just s) -> negative s
  ("comparison", Just s) -> [Fix "Compare with ==" [Edit s "=="]]
  ("missing-arrow", Just s) -> [Fix "Write an arrow" [Edit s (if textAt source s == "," then " ->" else "->")]]
  ("missing-colon", Just s) -> [Fix "Write two colons" [Edit s "::"]]
  ("field-value", Just s) -> [Fix "Write =" [Edit s "="]]
  ("definition", Just s) -> [Fix "Write =" [Edit s "="]]
  ("comment", Just s) -> [Fix "Write --" [Edit s "--"]]
  ("missing-where", Just s) -> [Fix "Add where" [Edit (nothingAt (end s)) " where"]]
  ("word", Just s) | textAt source s `elem` ["elif", "elsif", "elseif"] -> [Fix "Write else if" [Edit s "else if"]]
  ("character", Just s) -> [Fix ("Write " <> good) [Edit s good] | Just good <- [lookup (textAt source s) plain]]
  ("tab", _) -> [Fix "Write spaces for all tabs" tabs | not (null tabs)]
  _ -> []
  where
    source = text outline
    everything = flat (Text.unwords (important raw ++ context raw ++ supplementary raw))
    spelled s n = Fix ("Write " <> n) [Edit s n]

    -- What the compiler knows to be in place of a hole is named in the hint already.
    fitting = maybe [] quotes (after "for example " (hint p))

    imports s =
      [ Fix ("Import " <> what) [Edit (nothingAt (importPlace source)) (line' <> "\n")]
        | (what, line') <- case Text.breakOnEnd "." (textAt source s) of
            (q, _) | not (Text.null q) -> [(m, "import qualified " <> m <> " as " <> q') | q' <- [Text.dropEnd 1 q], Just m <- [moduleOf q']]
            (_, n) -> [(n, "import " <> m <> " (" <> n <> ")") | Just m <- [importFor n]]
      ]

    equation s =
      [ Fix ("Define " <> n) [Edit (nothingAt (end whole)) ("\n" <> n <> Text.replicate (arrows n) " _" <> " = _")]
        | n <- [textAt source s],
          Just whole <- [lookup n (signatures outline)]
      ]
    arrows n = maybe 0 (\whole -> length (splitArrows (fromMaybe "" (after "::" (flat (textAt source whole))))) - 1) (lookup n (signatures outline))

    tabs = [Edit (Span (Place l c) (Place l (c + 1))) (Text.replicate (width l c) " ") | (l, t) <- zip [1 ..] (Text.lines source), c <- tabsIn t]
    tabsIn t = [c | (c, '\t') <- zip [1 ..] (Text.unpack t)]
    -- A tab goes on to the next column after a multiple of eight.
    width l c = 8 - (foldl' advance 0 (take (c - 1) (Text.unpack (lineOf source l))) `mod` 8)
    advance n '\t' = n + 8 - n `mod` 8
    advance n _ = n + 1 :: Int
    foldl' f z xs = foldr (\x k acc -> k $! f acc x) id xs z

    negative s =
      let rest = Text.drop (column (start s) - 1) (lineOf source (line (start s)))
          (sign, behind) = Text.splitAt (column (end s) - column (start s)) rest
          gap = Text.takeWhile isSpace behind
          value = Text.takeWhile (\c -> isAlphaNum c || c `elem` ("._'" :: String)) (Text.dropWhile isSpace behind)
          upto = (end s) {column = column (end s) + Text.length gap + Text.length value}
       in [Fix "Put brackets around it" [Edit (Span (start s) upto) ("(" <> sign <> value <> ")")] | sign == "-", not (Text.null value)]

    cases s
      | Just name <- owner = equations name s
      | otherwise = alternatives s
    owner = between "equation for ‘" "’" (flat (Text.unwords (important raw)))
    missing = maybe [] (filter (not . Text.null) . map Text.strip . Text.lines) (after "Patterns not matched:" (Text.unlines (important raw)))
    -- All of them, each as it can be written: no condition on a name, and none left out.
    exact = not (null missing) && all writable missing
    writable m = not (" where " `Text.isInfixOf` m) && m /= "..."

    equations name s =
      let begin = maybe (start s) start (lookup name (bindings outline))
          n = arity source begin
          left ps = "\n" <> Text.replicate (column begin - 1) " " <> name <> " " <> ps <> " = _"
          whole m = if n == 1 then bracketed m else m
       in [Fix "Add the missing cases" [Edit (nothingAt (end s)) (Text.concat (map (left . whole) missing))] | exact, n > 0]
            ++ [Fix "Add a case for everything else" [Edit (nothingAt (end s)) (left (Text.unwords (replicate n "_")))] | n > 0]

    alternatives s = case filter (not . Text.null . Text.strip) (map (lineOf source) [line (start s) + 1 .. line (end s)]) of
      first : _ ->
        let indent = Text.takeWhile isSpace first
            right m = "\n" <> indent <> m <> " -> _"
         in [Fix "Add the missing cases" [Edit (nothingAt (end s)) (Text.concat (map right missing))] | exact]
              ++ [Fix "Add a case for everything else" [Edit (nothingAt (end s)) (right "_")]]
      [] -> []

    bracket s =
      let here = textAt source s
          found = scan source
          opened = find ((== start s) . from) found
       in case opened of
            Just t
              | "never closed" `Text.isInfixOf` message p -> [Fix ("Add " <> closing here) [Edit (nothingAt (closingPlace t (dropWhile ((<= from t) . from) found))) (closing here)]]
              | Just wanted <- listToMaybe (quotes (hint p)), "closes a bracket" `Text.isInfixOf` message p -> [Fix ("Write " <> wanted) [Edit s wanted]]
              | otherwise -> [Fix "Remove it" [Edit s ""] | complete (takeWhile ((< from t) . from) found)]
            Nothing -> []

    -- Whether a definition may end behind these: with a value, and without a comma outside of brackets, which asks for the opening one.
    complete before = case reverse before of
      t : _ -> (Text.all isNamed (word t) || word t `elem` [")", "]", "}", "\""]) && not (loose (0 :: Int) (reverse before))
      [] -> False
    isNamed c = isAlphaNum c || c `elem` ("_'" :: String)
    -- From the last token back to the one at the left edge.
    loose _ [] = False
    loose n (t : ts)
      | n == 0, word t == "," = True
      | column (from t) == 1 = False
      | word t `elem` [")", "]", "}"] = loose (n + 1) ts
      | word t `elem` ["(", "[", "{"] = loose (n - 1) ts
      | otherwise = loose n ts

-- | The names that GHC thinks may have been meant instead of one.
nearMisses :: Text -> Text -> [Text]
nearMisses everything unknownName = foldr keep [] (maybe [] quotes (after "Perhaps you meant" everything))
  where
    keep n ns = if n == unknownName || n `elem` ns || Text.all (== ' ') n then ns else n : ns

nothingAt :: Place -> Span
nothingAt at = Span at at

lineOf :: Text -> Int -> Text
lineOf source l = fromMaybe "" (listToMaybe (drop (l - 1) (Text.splitOn "\n" source)))

-- | The text between two places.
textAt :: Text -> Span -> Text
textAt source (Span s e)
  | line s == line e = Text.take (column e - column s) (Text.drop (column s - 1) (lineOf source (line s)))
  | otherwise = Text.intercalate "\n" ([Text.drop (column s - 1) (lineOf source (line s))] ++ map (lineOf source) [line s + 1 .. line e - 1] ++ [Text.take (column e - 1) (lineOf source (line e))])

-- | In brackets, if it is more than one thing.
bracketed :: Text -> Text
bracketed t
  | Text.any isSpace t && not (Text.isPrefixOf "(" t && enclosed (Text.unpack t)) = "(" <> t <> ")"
  | otherwise = t
  where
    -- The bracket that opens it closes only at its end.
    enclosed = go (0 :: Int)
    go n ('(' : cs) = go (n + 1) cs
    go 1 (')' : cs) = null cs
    go n (')' : cs) = go (n - 1) cs
    go n (_ : cs) = go n cs
    go _ [] = False

-- | How many patterns an equation takes whose name stands at a place.
arity :: Text -> Place -> Int
arity source at = count (0 :: Int) (drop 1 (dropWhile ((< at) . from) (scan source)))
  where
    count _ [] = 0
    count 0 (t : _) | word t `elem` ["=", "|"] = 0
    count n (t : ts)
      | word t `elem` ["(", "["] = (if n == 0 then 1 else 0) + count (n + 1) ts
      | word t `elem` [")", "]"] = count (n - 1) ts
      -- @x\@p@ is one pattern.
      | n == 0, word t == "@" = count n ts - 1
      | n == 0 = 1 + count n ts
      | otherwise = count n ts

closing :: Text -> Text
closing "(" = ")"
closing "[" = "]"
closing _ = "}"

-- | Where a bracket that was never closed most likely ends: before what cannot stand in brackets, or where the lines inside it end.
closingPlace :: Token -> [Token] -> Place
closingPlace open = go (upTo open) (0 :: Int)
  where
    go at _ [] = at
    go at n (t : ts)
      | line (from t) > line at, column (from t) <= column (from open) = at
      | n == 0, word t `elem` ["=", "|", "->", "<-", "::", "then", "else", "of", "where"] = at
      | word t `elem` ["(", "[", "{"] = go (upTo t) (n + 1) ts
      | word t `elem` [")", "]", "}"] = go (upTo t) (max 0 (n - 1)) ts
      | otherwise = go (upTo t) n ts

-- | Above the first import, or below what comes before all imports.
importPlace :: Text -> Place
importPlace source = Place (maybe (1 + header) fst (find (Text.isPrefixOf "import " . snd) numbered)) 1
  where
    numbered = zip [1 ..] (Text.splitOn "\n" source)
    header = length (takeWhile isHeader (Text.splitOn "\n" source))
    isHeader l = any (`Text.isPrefixOf` l) ["{-# LANGUAGE", "{-# OPTIONS", "module "]

-- | Signs of other keyboards, and the plain ones.
plain :: [(Text, Text)]
plain = [("“", "\""), ("”", "\""), ("„", "\""), ("−", "-"), ("–", "-"), ("—", "-")]
