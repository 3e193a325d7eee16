{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Explanation.TextualAdvice
-- Description : Doubts about programs that compile, found in their text.
--
-- Numbers that fit another unit, names that mean something else than they seem to, and functions that nothing uses. Pure.
module Rosy.Worker.Explanation.TextualAdvice
  ( withTextualAdvice,
  )
where

import Data.Bifunctor (first)
import Data.List (sortOn, tails)
import Data.Maybe (isJust, isNothing, listToMaybe)
import qualified Data.Set as Set
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.CompilerMessage (ProgramOutline (..), enclosing)
import Rosy.Worker.Explanation.MessageText (lineOf, splitArrows, textAt)
import Rosy.Worker.Explanation.RobotVocabulary
import Rosy.Worker.Explanation.TextRepair
import Rosy.Worker.Explanation.Tokenizer
import Rosy.Worker.Problem
import Rosy.Worker.Sentence

-- | Adds the doubts to the other problems of a program without errors, and leaves out the warnings that follow from them.
withTextualAdvice :: ProgramOutline -> [Problem] -> [Problem]
withTextualAdvice outline others = filter (not . follows) others ++ sortOn place doubts
  where
    program = programOf (text outline)
    misspelt = misspeltEquations others outline program
    doubts = map located (misspelt ++ concatMap (\rule -> rule outline program) [smallConstructors, selfDefinitions, otherwiseEquations, speeds, distances, tasksAtOnce, unusedFunctions [textAt (text outline) s | Just s <- map place misspelt], idleProgram])
    located d = case function d of
      Nothing -> d {function = place d >>= enclosing outline}
      Just _ -> d
    follows o = or [kind o == "missing-cases" && kind d == "misspelt" && function o == function d | d <- doubts] || or [kind o `elem` ["unreachable", "missing-cases"] && kind d `elem` ["capital", "word"] && (function o == function d || fmap start (place o) < fmap start (place d)) | d <- doubts]

as :: Severity -> Problem -> Problem
as s p = p {severity = s}

isDefined :: ProgramOutline -> Text -> Bool
isDefined outline n = isJust (lookup n (bindings outline))

-- | Equations below those of a function that lacks cases, whose name differs from its name by one mistake in typing, and which nothing else uses.
misspeltEquations :: [Problem] -> ProgramOutline -> Program -> [Problem]
misspeltEquations others outline p =
  [ (as Warning (repairedWith p (tokenSpan n) "misspelt" (trWith "There is no type for ‘{name}’." ["name" =: word n]) (trWith "Did you mean {or names}?" ["names" =* [word f]]) [Edit (tokenSpan t) (word f) | t <- tokens p, word t == word n])) {function = Just (word f)}
    | (f : left, n : right) <- zip heads (drop 1 heads),
      word f /= word n,
      isName (word n),
      isJust (lookup (word f) (signatures outline)),
      isNothing (lookup (word n) (signatures outline)),
      word n `elem` map fst (bindings outline),
      all ((/= "::") . word) (take 1 left ++ take 1 right),
      or [kind o == "missing-cases" && function o == Just (word f) | o <- others],
      word f `isNearly` word n,
      null [t | t <- tokens p, word t == word n, ownerOf p (line (from t)) /= Just (word n)],
      parameters left == parameters right
  ]
  where
    heads = [row | row@(t : _) <- rows p, column (from t) == 1]
    -- The number of patterns.
    parameters = count (0 :: Int) . takeWhile (`notElem` ["=", "|"]) . map word
    count :: Int -> [Text] -> Int
    count depth ws = case ws of
      [] -> 0
      w : rest
        | w `elem` ["(", "["] -> (if depth == 0 then 1 else 0) + count (depth + 1) rest
        | w `elem` [")", "]"] -> count (depth - 1) rest
        | otherwise -> (if depth == 0 then 1 else 0) + count depth rest

-- | Whether a word becomes the other one by one letter more, less or other, or by two neighbours in the other order.
isNearly :: Text -> Text -> Bool
isNearly a b = case Text.commonPrefixes a b of
  Just (_, x, y) -> differs (Text.unpack x) (Text.unpack y)
  Nothing -> False
  where
    differs (x : xs) (y : ys) = xs == ys || xs == y : ys || x : xs == ys || take 2 (x : xs) == reverse (take 2 (y : ys)) && drop 1 xs == drop 1 ys
    differs xs ys = length xs + length ys == 1

-- | A name in a pattern that is the name of a value but for its first letter: @(Wheel _ air)@.
smallConstructors :: ProgramOutline -> Program -> [Problem]
smallConstructors _ p =
  [ as Warning (repaired p (tokenSpan t) "capital" (trWith "‘{name}’, with a small letter, stands for anything." ["name" =: word t]) [Edit (tokenSpan t) (capitalised (word t))])
    | row <- rows p,
      (left, _ : _) <- [break ((`elem` ["=", "->", "|"]) . word) row],
      all ((`notElem` ["::", "if", "data"]) . word) left,
      c : inside <- tails left,
      isConstructor (word c),
      t <- takeWhile ((`notElem` [")", ","]) . word) inside,
      isName (word t),
      isJust (typeOfValue (capitalised (word t))),
      -- It is used nowhere.
      length (filter ((== word t) . word) [x | x <- tokens p, chunkOf p (line (from x)) == chunkOf p (line (from t))]) == 1
  ]

-- | A value that is calculated from itself: @n = n + 1@.
selfDefinitions :: ProgramOutline -> Program -> [Problem]
selfDefinitions _ p =
  [ as Warning (repairedWith p (Span (from n) (to value)) "endless" (trWith "‘{name}’ is calculated from itself, so it never gets a value." ["name" =: word n]) hint' repair)
    | row <- rows p,
      n : e : more <- startsOf row,
      isName (word n),
      word e == "=",
      value@(_ : _) <- [takeWhile ((`notElem` ["in", "where", "then", "else", ";", ","]) . word) more],
      any (\(a, b) -> word a == word n && isSign b || isSign a && word b == word n) (zip value (drop 1 value)),
      all ((`notElem` [":", "\\", "if", "case", "++"]) . word) value,
      let (hint', repair) = withAnotherName n value
  ]
  where
    startsOf row = [row | take 1 (map word row) `notElem` [["let"], ["where"]]] ++ [rest | k : rest <- tails row, word k `elem` ["let", "where"]]
    isSign t = word t `elem` ["+", "-", "*", "/"]
    to = maybe (Position 1 1) tokenEnd . listToMaybe . reverse
    -- The new value gets a name that the program does not have. Where it is used only once, that use is surely meant.
    withAnotherName n value
      | null earlier = (rememberedHint (word n), [])
      | [use] <- uses, line (from use) /= line (from n) = (trWith "Give the new value another name, and use that name: {code}, with: {definition}" ["code" =: Text.strip (lineOf (edited (renamed use) (source p)) (line (from use))), "definition" =: (keyword <> definition)], renamed use)
      | [use] <- uses = (trWith "Give the new value another name, and use that name: {code}" ["code" =: Text.strip (lineOf (edited (renamed use) (source p)) (line (from use)))], renamed use)
      | otherwise = (trWith "Give the new value another name, and use that name where it is meant: {code}" ["code" =: definition], [])
      where
        keyword = Text.concat [word k <> " " | k : m : _ <- tails (rowOf n), m == n, word k `elem` ["where", "let"]]
        definition = new <> " = " <> Text.strip (textAt (source p) (Span (maybe (from n) from (listToMaybe value)) (to value)))
        renamed use = [Edit (tokenSpan t) new | t <- [n, use]]
        new = head' [w | k <- [2 :: Int ..], let w = word n <> Text.pack (show k), w `notElem` map word (tokens p)]
        others = [t | t <- tokens p, chunkOf p (line (from t)) == chunkOf p (line (from n)), word t == word n, t /= n, t `notElem` value]
        -- What the name means outside: a parameter, or what a step of a do gave.
        (earlier, uses) = span' isEarlier others
        isEarlier t = line (from t) == firstLine && from t < equals || "<-" `elem` map word (drop 1 (dropWhile (/= t) (rowOf t)))
        firstLine = maybe 1 (line . from) (listToMaybe chunkTokens)
        equals = maybe (from n) from (listToMaybe [t | t <- chunkTokens, word t `elem` ["=", "|", "->"]])
        chunkTokens = [t | t <- tokens p, chunkOf p (line (from t)) == chunkOf p (line (from n))]
    rowOf t = concat [row | row <- rows p, t `elem` row]
    span' f ts = (filter f ts, filter (not . f) ts)
    head' = foldr const ""

-- | @otherwise@ in place of a function's last equation.
otherwiseEquations :: ProgramOutline -> Program -> [Problem]
otherwiseEquations _ p = map (as Warning) (lastEquations p)

-- | Literal speeds that no robot reaches.
speeds :: ProgramOutline -> Program -> [Problem]
speeds _ p
  | any ((== "Velocity") . word) (concat [take 2 row | row <- rows p, (word <$> listToMaybe row) `elem` map Just ["data", "newtype", "type"]]) = []
  | otherwise = concat [speed a ++ turning b | v : more <- tails (tokens p), word v == "Velocity", (a, rest) <- literal more, (b, _) <- literal rest]
  where
    (fastest, quickest) = robotLimits
    speed (s, x)
      | abs x < 2 = []
      | otherwise = [as Note (repairedWith p s "too-fast" (trWith "The robot drives at most {most} metres a second, and this says {value}." ["most" =: shown fastest, "value" =: shown (abs x)]) (trWith "For {value} centimetres a second, write {code}" ["value" =: shown (abs x), "code" =: shown (abs x / 100)]) [Edit s (bracketedNegative (x / 100)) | abs x / 100 <= fastest])]
    turning (s, x)
      | abs x < 7 = []
      | otherwise = [as Note (repairedWith p s "too-fast" (trWith "The robot turns at most {most} radians a second, and this says {value}." ["most" =: shown (fromInteger (round (quickest * 100)) / 100), "value" =: shown (abs x)]) (trWith "For {value} degrees a second, write {code}" ["value" =: shown (abs x), "code" =: degrees' x]) [Edit s (degrees' x) | abs x <= quickest * 180 / pi])]
    degrees' x = "(degreesToRadians " <> bracketedNegative x <> ")"

bracketedNegative :: Double -> Text
bracketedNegative x = if x < 0 then "(-" <> shown (abs x) <> ")" else shown x

-- | A literal number, with brackets around a negative one, and what follows.
literal :: [Token] -> [((Span, Double), [Token])]
literal ts = case ts of
  o : m : n : c : rest | map word [o, m, c] == ["(", "-", ")"], Just x <- value n -> [((spanOf o c, negate x), rest)]
  n : rest | Just x <- value n -> [((tokenSpan n, x), rest)]
  _ -> []
  where
    value = readNumber . word

readNumber :: Text -> Maybe Double
readNumber w
  | isNumeral w, [(x, "")] <- reads (Text.unpack w) = Just x
  | otherwise = Nothing

-- | Numbers of @drive@, @turn@ and @wait@ that fit metres, radians and milliseconds.
distances :: ProgramOutline -> Program -> [Problem]
distances outline p =
  [note | t : more <- tails (tokens p), word t `elem` ["drive", "turn", "wait"], not (isDefined outline (word t)), ((s, x), _) <- literal more, note <- judged (word t) s x (textAt (source p) s)]
    ++ [ as Note (repaired p (spanOf o c) "unit" (tr "‘turn’ takes degrees, and pi belongs to radians.") [Edit (spanOf o c) converted])
         | t : o : more <- tails (tokens p),
           word t == "turn",
           not (isDefined outline "turn"),
           (inside, c) <- [([o], o) | word o == "pi"] ++ [(inside, z) | word o == "(", (inside, z : _) <- [break ((`elem` ["(", ")"]) . word) more], word z == ")", "pi" `elem` map word inside],
           let converted = maybe ("(radiansToDegrees " <> textAt (source p) (spanOf o c) <> ")") shown (degreesOf (map word inside))
       ]
  where
    judged f s x written
      | f == "drive", abs x > 0, abs x < 1 || isFraction written && abs x <= 3 = [about f s x (trWith "‘drive’ takes centimetres: this is {value} centimetres." ["value" =: shown (abs x)]) (\n -> trWith "For {value} metres, write {code}" ["value" =: shown (abs x), "code" =: n]) (x * 100)]
      | f == "turn", isFraction written, abs x <= 6.3 = [about f s x (trWith "‘turn’ takes degrees: this is {value} degrees." ["value" =: shown (abs x)]) (\n -> trWith "For {value} radians, write {code}" ["value" =: shown (abs x), "code" =: n]) (fromInteger (round (x * 180 / pi)))]
      | f == "wait", x >= 500 = [about f s x (trWith "‘wait’ takes seconds: this is {value} seconds." ["value" =: shown x]) (\n -> trWith "For {value} milliseconds, write {code}" ["value" =: shown x, "code" =: n]) (x / 1000)]
      | otherwise = []
    about f s _ m h better = as Note (repairedWith p s "unit" m (h (f <> " " <> bracketedNegative better)) [Edit s (bracketedNegative better)])
    isFraction written = "." `Text.isInfixOf` written
    -- Multiples and fractions of half a turn.
    degreesOf ws = case ws of
      ["pi"] -> Just 180
      ["pi", "/", n] -> (180 /) <$> readNumber n
      ["pi", "*", n] -> (180 *) <$> readNumber n
      [n, "*", "pi"] -> (180 *) <$> readNumber n
      [n, "*", "pi", "/", m] -> (\x y -> 180 * x / y) <$> readNumber n <*> readNumber m
      _ -> Nothing

-- | Ready-made tasks that all move the robot, side by side behind @simulate@: a sequence is more often meant.
tasksAtOnce :: ProgramOutline -> Program -> [Problem]
tasksAtOnce outline p =
  [ as Note (repairedWith p (spanOf o z) "at-once" (tr "These tasks run at the same time.") (trWith "For one after the other, write: {code}" ["code" =: code]) [Edit (spanOf o z) code])
    | s : o : more <- tails (tokens p),
      word s == "simulate" && word o == "(",
      Just (parts@(_ : _ : _), z) <- [partsOf (0 :: Int) [] more],
      all (maybe False (\t -> word t `elem` ["drive", "turn", "driveUntilBump"] && not (isDefined outline (word t))) . listToMaybe) parts,
      let code = "(do " <> Text.intercalate "; " [textAt (source p) (Span (from begin) (tokenEnd final)) | part@(begin : _) <- parts, final : _ <- [reverse part]] <> ")"
  ]
  where
    -- The parts of a tuple, each backwards while it is read, and its closing bracket.
    partsOf depth part ts = case ts of
      t : rest
        | word t == ")" && depth == 0 -> Just ([reverse part], t)
        | word t == "," && depth == 0 -> first (reverse part :) <$> partsOf depth [] rest
        | word t `elem` ["(", "["] -> partsOf (depth + 1) (t : part) rest
        | word t `elem` [")", "]"] -> partsOf (depth - 1) (t : part) rest
        | otherwise -> partsOf depth (t : part) rest
      [] -> Nothing

-- | Functions of the program that nothing else in it names.
unusedFunctions :: [Text] -> ProgramOutline -> Program -> [Problem]
unusedFunctions misspelt outline p =
  [ (as Note (repairedWith p (tokenSpan f) "unused" (trWith "‘{function}’ is never used." ["function" =: word f]) (hintFor (word f)) [])) {function = Just (word f)}
    | isDefined outline "main",
      f : _ <- rows p,
      column (from f) == 1,
      word f /= "main",
      Just whole <- [lookup (word f) (bindings outline)],
      start whole == from f,
      word f `Set.notMember` used,
      word f /= "otherwise",
      not ("_" `Text.isPrefixOf` word f),
      word f `notElem` misspelt
  ]
  where
    -- Names on the lines of other definitions. A function that only calls itself is not used.
    used = Set.fromList [word t | (owner, t) <- owned "" (rows p), word t /= owner]
    owned owner (row@(f : _) : more) = let now = if column (from f) == 1 then word f else owner in [(now, t) | t <- row] ++ owned now more
    owned owner ([] : more) = owned owner more
    owned _ [] = []
    hintFor f
      | isForRobot f, [given] <- [Text.unwords (map word behind) | m : e : s : behind@(_ : _) <- rows p, map word [m, e, s] == ["main", "=", "simulate"], all ((\w -> isName w || w `elem` ["(", ")", ","]) . word) behind] = trWith "If the robot is to do this too, write: {code}" ["code" =: ("main = simulate (" <> Text.intercalate ", " (filter (`notElem` ["(", ")", ","]) (Text.words given) ++ [f]) <> ")")]
      | otherwise = tr "Use it, or remove it."
    isForRobot f = maybe False (any (`elem` robotNames) . Text.words . Text.map (\c -> if c `elem` ("()," :: String) then ' ' else c) . last . splitArrows) (lookup f (typesOfNames outline))

-- | A program that runs without giving the robot anything to do. One whose @main@ is @pure ()@ says so itself.
idleProgram :: ProgramOutline -> Program -> [Problem]
idleProgram outline p =
  [ (as Note (repairedWith p s "no-simulate" (tr "This program gives the robot nothing to do.") (tr "Begin with simulate, for example: main = simulate (say \"hello\")") [])) {function = Just "main"}
    | not (any (("simulate" `Text.isPrefixOf`) . word) (tokens p)),
      ["main", "=", "pure", "(", ")"] `notElem` map (map word) (rows p),
      Just s <- [lookup "main" (bindings outline)]
  ]
