{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Explanation.TextualMistakes.Numbers
-- Description : Numbers and calculations as other languages, calculators and people write them, and numbers with units.
module Rosy.Worker.Explanation.TextualMistakes.Numbers
  ( units,
    numbers,
  )
where

import Data.Char (isDigit)
import Data.List (find, tails)
import Data.Maybe (fromMaybe, listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.Explanation.MessageText (textAt)
import Rosy.Worker.Explanation.RobotVocabulary (robotLimits)
import Rosy.Worker.Explanation.TextRepair
import Rosy.Worker.Explanation.Tokenizer
import Rosy.Worker.Problem
import Rosy.Worker.Sentence

data Dimension = Length | Angle | Time
  deriving (Eq)

-- | A number with a unit behind it, where the function or constructor in front says which unit is meant.
units :: Program -> [Problem]
units p =
  [ repaired p (spanOf n u) "unit" message' [Edit (spanOf n u) new]
    | (before, n : behind) <- zip (scanl (flip (:)) [] (tokens p)) (tails (tokens p)),
      (digits, unit, u) <- quantities n behind,
      Just (dimension, factor) <- [lookup unit unitFactors],
      Just value <- [readDecimal digits],
      Just (message', new) <- [converted (map word before) dimension (value * factor)]
  ]

-- | How a number with a unit can be read: the number, the unit, and the last token of both. The unit follows at once or as the next token.
quantities :: Token -> [Token] -> [(Text, Text, Token)]
quantities n behind = glued ++ apart
  where
    glued =
      [ (digits, Text.toLower unit, unitEnd unit n behind)
        | (digits, unit) <- [Text.span (\c -> isDigit c || c == '.') (word n)],
          not (Text.null digits || Text.null unit)
      ]
    apart =
      [ (word n, Text.toLower (word u), unitEnd (word u) u more)
        | isNumeral (word n),
          u : more <- [behind],
          line (from u) == line (from n)
      ]
    -- A speed ends with @/s@.
    unitEnd unit u more = case more of
      slash : s : _ | unit `elem` ["m", "cm", "rad"], word slash == "/", word s == "s" -> s
      _ -> u

-- | A value in metres, radians or seconds as the place needs it, which the words in front of it tell, the nearest first.
converted :: [Text] -> Dimension -> Double -> Maybe (Sentence, Text)
converted before dimension value = case dropWhile (`elem` ["(", "-"]) before of
  "drive" : _ | dimension == Length -> Just (tr "‘drive’ takes centimetres, and the unit is not written.", shown (value * 100))
  "turn" : _ | dimension == Angle -> Just (tr "‘turn’ takes degrees, and the unit is not written.", degrees)
  "wait" : _ | dimension == Time -> Just (tr "‘wait’ takes seconds, and the unit is not written.", shown value)
  "Velocity" : _ | dimension == Length -> Just (perSecond, shown value)
  _
    | dimension == Angle, "Velocity" `elem` arguments -> Just (perSecond, if isNegative then conversion else "(" <> conversion <> ")")
    | otherwise -> Nothing
  where
    perSecond = tr "‘Velocity’ takes metres and radians a second, and no unit is written."
    degrees = shown (value * 180 / pi)
    conversion = "degreesToRadians " <> degrees
    isNegative = take 1 before == ["-"]
    -- The first argument of Velocity may stand in between.
    arguments = takeWhile (\w -> isNumeral w || w `elem` ["(", ")", "-", "Velocity"]) (take 6 before)

-- | Units in the languages of the page, with their sizes in metres, radians and seconds.
unitFactors :: [(Text, (Dimension, Double))]
unitFactors =
  [ (name, (dimension, size))
    | (names, dimension, size) <-
        [ ("mm", Length, 0.001),
          ("cm centimeter centimeters centimetre centimetres zentimeter centímetros centimètres", Length, 0.01),
          ("m meter meters metre metres mètre mètres metro metros", Length, 1),
          ("° deg degree degrees grad degrés grados graus", Angle, pi / 180),
          ("rad radian radians", Angle, 1),
          ("ms millisecond milliseconds", Time, 0.001),
          ("s sec secs second seconds sek sekunde sekunden secondes segundos", Time, 1),
          ("min minute minutes minuten minutos", Time, 60)
        ],
      name <- Text.words names
  ]

readDecimal :: Text -> Maybe Double
readDecimal t = case reads (Text.unpack t) of
  [(x, "")] -> Just x
  _ -> Nothing

-- | Numbers and calculations with the signs of other languages.
numbers :: Program -> [Problem]
numbers p = percentages p ++ concatMap (speedsWithUnit p) (rows p) ++ concatMap (superscripts p) (zip (Nothing : map Just (tokens p)) behind) ++ concatMap (strokes p) behind ++ digitKeys p ++ remainders p ++ concatMap (points p) behind ++ concatMap (calculations p) behind ++ concatMap (digitSeparators p) (tokens p)
  where
    behind = tails (tokens p)

-- | Remainders of divisions as other languages write them: @n % 2@. The repair is for two names or whole numbers that belong to nothing else around
-- them, in a definition that does not calculate with decimal numbers.
remainders :: Program -> [Problem]
remainders p =
  [ if isCertain
      then repaired p (tokenSpan s) "operator" message' [Edit (spanOf x y) (if isBracketed then calculation else "(" <> calculation <> ")")]
      else repairedWith p (tokenSpan s) "operator" message' (if hasDecimals x then ofEither x y else trWith "Write, for example: {code}" ["code" =: "mod 7 2"]) []
    | (before, x : s : y : behind) <- zip (scanl (flip (:)) [] (tokens p)) (tails (tokens p)),
      word s == "%",
      isOperand (word x) && word x `notElem` ["(", "\"", "_"],
      isOperand (word y) && word y `notElem` [")", "\"", "_"],
      line (from x) == line (from y),
      let left = [word t | t <- take 1 before, line (from t) == line (from x)],
      let right = [word t | t <- take 1 behind, line (from t) == line (from y)],
      let isBracketed = left == ["("] && right == [")"],
      let calculation = Text.unwords ["mod", word x, word y],
      let isCertain = all isWholeValue [x, y] && not (any isOperand (filter (/= "(") left ++ filter (/= ")") right)) && not (any (`elem` ["-", "*", "/", "%", ".", "^"]) left) && not (any (`elem` [".", "^"]) right) && not (hasDecimals x)
  ]
  where
    message' = tr "In Haskell, the remainder is written with mod, in front of both numbers."
    -- Beside decimal numbers either may be meant, and mod is for whole ones alone.
    ofEither x y = trWith "Of whole numbers, write {whole}, and of decimal ones {decimal}" ["whole" =: Text.unwords ["mod", n, m], "decimal" =: Text.unwords [n, "-", m, "* fromIntegral (floor (" <> n, "/", m <> "))"]]
      where
        (n, m) = if all isOneWord [x, y] then (word x, word y) else ("7", "2")
    isOneWord t = isNumeral (word t) || isName (word t)
    isWholeValue t = isWhole (word t) || isName (word t)
    hasDecimals x = or [isDecimal (word t) | t <- tokens p, ownerOf p (line (from t)) == ownerOf p (line (from x))]
    isDecimal w = w `elem` ["Double", "Float"] || w `elem` measured || isNumeral w && not (isWhole w)
    measured = ["Velocity", "Position", "Orientation", "Pose", "Ahead", "TurnRate", "Battery", "AnalogInput", "Seconds"]

-- | Percentages. What is meant depends on the function or constructor in front: half of the highest speed is not 0.5.
percentages :: Program -> [Problem]
percentages p =
  [ percentage p (map word before) (spanOf n s) x
    | (before, n : s : behind) <- zip (scanl (flip (:)) [] (tokens p)) (tails (tokens p)),
      isNumeral (word n),
      word s == "%",
      line (from s) == line (from n),
      isPercent before n s (listToMaybe behind),
      Just x <- [readDecimal (word n)]
  ]
  where
    -- And no remainder of a division, as other languages write it.
    isPercent before n s next
      | isGlued n s = not (maybe False (\v -> isGlued s v && beginsValue v) next)
      | otherwise = map word (take 1 before) == ["Velocity"] || not (maybe False (\v -> line (from v) == line (from s) && beginsValue v) next)
    beginsValue v = isOperand (word v) && word v /= ")"

-- | A percentage after these words, the nearest first.
percentage :: Program -> [Text] -> Span -> Double -> Problem
percentage p before s x = case dropWhile (`elem` ["(", "-"]) before of
  "Velocity" : _ -> ofMost (tr "‘Velocity’ takes metres a second, not per cent.") (\code -> trWith "The robot drives at most {most} metres a second: for {value} % of that, write {code}" ["most" =: shown fastest, "value" =: shown part, "code" =: code]) (shown (fastest * part / 100))
  "drive" : _ -> alone (tr "‘drive’ takes a length in centimetres, not per cent.") (trWith "For half a metre, write: {code}" ["code" =: "drive 50"])
  "wait" : _ -> alone (tr "‘wait’ takes seconds, not per cent.") (trWith "For half a second, write: {code}" ["code" =: "wait 0.5"])
  "turn" : _ -> ofMost (tr "‘turn’ takes degrees, not per cent.") (\code -> trWith "A full turn is 360 degrees: for {value} % of it, write {code}" ["value" =: shown part, "code" =: code]) (shown (360 * part / 100))
  _
    | "Velocity" `elem` takeWhile isArgument (take 7 before) -> ofMost (tr "‘Velocity’ takes radians a second here, not per cent.") (\code -> trWith "The robot turns at most {most} radians a second: for {value} % of that, write {code}" ["most" =: hundredths quickest, "value" =: shown part, "code" =: code]) (hundredths (quickest * part / 100))
    | otherwise -> repairedWith p s "number" (tr "Haskell has no sign for per cent.") (trWith "Write the number that is meant: {value} % of 1 is {code}" ["value" =: shown x, "code" =: shown (x / 100)]) []
  where
    (fastest, quickest) = robotLimits
    -- More than all of it is not offered.
    part = min 100 x
    ofMost message' hint' code = repairedWith p s "unit" message' (hint' code) [Edit s code | x <= 100]
    alone message' example = repairedWith p s "unit" message' example []
    hundredths y = shown (fromInteger (round (y * 100)) / 100)
    -- What may stand between a constructor and its second value.
    isArgument w = isNumeral w || isName w || w `elem` ["(", ")", "-", "%", "Velocity"]

-- | Functions that take one number.
oneNumber :: [Text]
oneNumber = ["drive", "turn", "wait"]

-- | Decimal points at the beginning or end of a number, and decimal commas. Takes the tokens from the one in front of the number on.
points :: Program -> [Token] -> [Problem]
points p ts = case ts of
  b : point : n : rest
    | word point `elem` [".", "-."],
      isGlued point n,
      startsWithDigit (word n),
      not (isGlued b point) || word b `elem` ["(", "[", ","],
      let new = signed b (word point) ("0." <> word n) rest,
      let message' = if "(" `Text.isPrefixOf` new then tr "A number begins with a digit, and a negative number needs brackets." else tr "A number begins with a digit." ->
      [repaired p (spanOf point n) "number" message' [Edit (spanOf point n) new]]
  b : n : point : rest
    | isWhole (word n),
      word point == ".",
      isGlued n point,
      maybe True (endsNumber point) (listToMaybe rest),
      line (from b) == line (from n) ->
      [repaired p (spanOf n point) "number" (tr "A number ends with a digit.") [Edit (spanOf n point) (word n <> ".0")]]
  b : n : comma : m : rest
    | isDecimal n comma m, isOneValueBehind b, fmap word (listToMaybe rest) /= Just "," -> [decimal (spanOf n m) n m]
  b : n : semicolon : m : _
    | word semicolon == ";",
      isGlued n semicolon,
      isGlued semicolon m,
      all (isWhole . word) [n, m],
      isOneValueBehind b ->
      [repaired p (spanOf n m) "number" (tr "A number has a point, not a semicolon.") [Edit (spanOf n m) (word n <> "." <> word m)]]
  b : o : n : comma : m : c : rest
    | word o == "(", word c == ")", isDecimal n comma m, isArgument b o c rest -> [decimal (spanOf o c) n m]
  _ -> []
  where
    endsNumber point x = not (isGlued point x) || word x `elem` [")", ",", "]"]
    isDecimal n comma m = word comma == "," && isGlued n comma && isGlued comma m && isNumeral (word n) && isWhole (word m)
    isOneValueBehind b
      | isOperand (word b) = word b `notElem` ["(", "_"]
      | otherwise = word b `elem` ["+", "-", "*", "/", "<", ">"] && "[" `notElem` map word (rowOf b)
    rowOf t = concat (find (any ((== line (from t)) . line . from) . take 1) (rows p))
    -- A number in brackets, and not a pair.
    isArgument b o c rest = word b `elem` oneNumber || not (isGlued b o) && isOperand (word b) && (word b == ")" || any (isOperand . word) (sameRow c rest))
    sameRow c rest = [x | x <- take 1 rest, line (from x) == line (from c)]
    signed b sign n rest
      | sign == "." = n
      | word b == "(", fmap word (listToMaybe rest) == Just ")" = "-" <> n
      | otherwise = "(-" <> n <> ")"
    decimal s n m = repaired p s "number" (tr "A number has a point, not a comma.") [Edit s (Text.filter (/= '.') (word n) <> "." <> word m)]

startsWithDigit :: Text -> Bool
startsWithDigit = maybe False (isDigit . fst) . Text.uncons

-- | Numbers in groups, calculations without brackets, and products without a sign.
calculations :: Program -> [Token] -> [Problem]
calculations p ts = case ts of
  f : a : b : _
    | word f `elem` oneNumber,
      isWhole (word a),
      isWhole (word b),
      Text.length (word b) == 3 ->
      [repaired p (spanOf a b) "number" digitsTogether [Edit (spanOf a b) (word a <> word b)]]
  f : a : o : b : _
    | word f `elem` ("Velocity" : oneNumber),
      word o `elem` ["/", "*", "+"],
      isNumeral (word a),
      isNumeral (word b) ->
      [repaired p (spanOf a b) "calculation" (tr "A calculation among other values needs brackets.") [Edit (spanOf a b) ("(" <> textAt (source p) (spanOf a b) <> ")")]]
  b : n : o : _
    | isNumeral (word n), word o == "(", isGlued n o, isAtStart b -> [times (spanOf n o) [Edit (nothingAt (tokenEnd n)) " * "]]
  b : n : _
    | (digits, name) <- Text.span isDigit (word n),
      not (Text.null digits || Text.null name),
      any ((== name) . word) (tokens p) ->
      let calculation = digits <> " * " <> name
       in [times (tokenSpan n) [Edit (tokenSpan n) (if isAtStart b then calculation else "(" <> calculation <> ")")]]
  _ -> []
  where
    -- Whether the token in front of a calculation takes no argument.
    isAtStart b = not (isOperand (word b)) || word b == "("
    times s = repaired p s "calculation" (tr "Multiplying is written with a star.")

digitsTogether :: Sentence
digitsTogether = tr "The digits of a number are written together."

-- | Signs between the digits of a number: @1'000@.
digitSeparators :: Program -> Token -> [Problem]
digitSeparators p t = [repaired p (tokenSpan t) "number" digitsTogether [Edit (tokenSpan t) plain] | isWhole plain, plain /= word t, startsWithDigit (word t)]
  where
    plain = Text.filter (`notElem` ("'_" :: String)) (word t)

-- | A speed with its unit as the value of a name: @speed = 20 cm/s@.
speedsWithUnit :: Program -> [Token] -> [Problem]
speedsWithUnit p row =
  [ repaired p (spanOf n s) "unit" (tr "Speeds are in metres a second, and no unit is written.") [Edit (spanOf n s) (shown (value * size))]
    | f : e : n : u : slash : s : _ <- [row],
      isName (word f) && map word [e, slash, s] == ["=", "/", "s"],
      Just size <- [lookup (word u) [("m", 1), ("cm", 0.01)]],
      Just value <- [readDecimal (word n)]
  ]

-- | A power as a small raised digit: @r²@. Takes the token in front as well.
superscripts :: Program -> (Maybe Token, [Token]) -> [Problem]
superscripts p (before, ts) = case ts of
  t : _
    | (base, sign) <- Text.span (`notElem` ("²³" :: String)) (word t),
      Just power <- lookup sign [("²", "2"), ("³", "3")] ->
      let new = base <> (if Text.null base then "" else " ") <> "^ " <> power
          isArgument = not (Text.null base) && maybe False (\b -> isOperand (word b) && word b /= "(" && line (from b) == line (from t)) before
       in [repaired p (tokenSpan t) "operator" (trWith "In Haskell, ‘{sign}’ is written {code}." ["sign" =: sign, "code" =: "^ " <> power]) [Edit (tokenSpan t) (if isArgument then "(" <> new <> ")" else (if Text.null base then " " else "") <> new)]]
  _ -> []

-- | A backslash or a colon between two numbers, where a division is meant.
strokes :: Program -> [Token] -> [Problem]
strokes p ts = case ts of
  o : n : s : m : c : _
    | word s == "\\" || word s == ":" && map word [o, c] == ["(", ")"],
      isGlued n s,
      isGlued s m,
      isNumeral (word n) || word s == "\\" && isName (word n),
      isNumeral (word m) ->
      [repaired p (tokenSpan s) "operator" (trWith "In Haskell, ‘{sign}’ is written {code}." ["sign" =: word s, "code" =: "/"]) [Edit (tokenSpan s) "/"]]
  _ -> []

-- | Letters that a French keyboard writes for digits without the shift key: @Velocity à.2 à@.
digitKeys :: Program -> [Problem]
digitKeys p =
  [ repaired p (tokenSpan first) "number" (trWith "‘{word}’ is on the key of a digit, without the shift key." ["word" =: word first]) [Edit (tokenSpan t) (digitsOf t) | t <- found]
    | found@(first : _) <- [filter isDigitKey (tokens p)]
  ]
  where
    isDigitKey t = not (Text.null (word t)) && Text.all (`elem` map fst keys) (word t) && word t `notElem` bound
    bound = [word t | row <- rows p, (left, _ : _) <- [break ((== "=") . word) row], t <- left]
    digitsOf t = Text.pack [fromMaybe c (lookup c keys) | c <- Text.unpack (word t)]
    keys = [('é', '2'), ('è', '7'), ('ç', '9'), ('à', '0')]
