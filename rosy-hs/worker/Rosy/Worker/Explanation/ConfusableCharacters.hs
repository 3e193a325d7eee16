{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Explanation.ConfusableCharacters
-- Description : Characters that look like those of Haskell and are others, and characters that cannot be seen.
--
-- Takes the program and an explained error. Where such a character is its cause, the problem names the character by its Unicode name at its
-- place, with repairs of this one and of all. Comments and texts in quotation marks are left alone. Pure.
module Rosy.Worker.Explanation.ConfusableCharacters
  ( explainConfusable,
    directionControls,
  )
where

import Data.Char (GeneralCategory (Format), chr, generalCategory, isAlphaNum, isAscii, isSpace, ord)
import Data.List (find)
import qualified Data.Map.Strict as Map
import Data.Text (Text)
import qualified Data.Text as Text
import Numeric (showHex)
import Rosy.Worker.CompilerMessage
import Rosy.Worker.Explanation.MessageText
import Rosy.Worker.Explanation.Tokenizer (Token (..), tokenize)
import Rosy.Worker.Problem
import Rosy.Worker.Sentence

-- | A character with its place and what is written in its place; 'within' is its name or number, empty for a sign.
data Confusable = Confusable {at :: Position, character :: Char, plain :: Text, within :: Text, inText :: Bool}

-- | The error, or in its place the character that causes it.
explainConfusable :: Text -> CompilerMessage -> Problem -> Problem
explainConfusable source raw p
  | isError p, Just c <- cause = (problemAt (oneAt c) "character" (messageOf c) (hintOf c)) {function = function p, ghc = ghc p, fixes = fixesOf c}
  | otherwise = p
  where
    found = confusables source
    cause = case (category raw, messageSpan raw) of
      (_, Just s) | category raw == Syntax || "Parse error" `Text.isInfixOf` messageText -> find (\c -> at c == start s && (inText c || isForeign source c || not (Text.null (within c)))) found <|| find (\c -> isNear s c && not (inText c) && (isForeign source c || isMixed (within c))) found
      (_, Just s) | "not in scope" `Text.isInfixOf` Text.toLower messageText -> find (\c -> start s <= at c && at c < end s && (isForeign source c || isMixed (within c) || isKnown (within c))) found
      _ -> Nothing
    messageText = Text.unwords (important raw)
    Nothing <|| y = y
    x <|| _ = x
    -- In the definition that ends, or begins, in the line of the error.
    isNear s c = line (at c) <= line (start s) && line (at c) >= maximum (1 : [l | (l, t) <- zip [1 .. line (start s) - 1] (Text.lines source), not (Text.null t), not (isSpace (Text.head t))])
    -- A name of nothing but letters that look Latin is a name in another language, unless the Latin one exists.
    isKnown name = not (Text.null name) && (latin name `elem` map word (tokenize source) || latin name `elem` quotedParts (Text.unwords (important raw ++ context raw ++ supplementary raw)))
    fixesOf c = Fix (if Text.null (plain c) then tr "Remove it" else trWith "Write {code}" ["code" =: writtenFor c]) (map edit (c : others)) : [Fix (tr "Replace all such characters in the program") (map edit everywhere) | length everywhere > length others + 1]
      where
        others = [o | not (Text.null (within c)), o <- found, line (at o) == line (at c), at o /= at c, within o == within c, abs (column (at o) - column (at c)) < Text.length (within c)]
        everywhere = [o | o <- found, at o == at c || any ((== at o) . at) others || isForeign source o || isMixed (within o)]
    writtenFor c = if Text.null (within c) then plain c else latin (within c)
    edit c = Edit (oneAt c) (plain c)

oneAt :: Confusable -> Span
oneAt c = Span (at c) (at c) {column = column (at c) + 1}

messageOf, hintOf :: Confusable -> Sentence
messageOf c
  | Text.null (plain c) || plain c == "\n" = trWith "Here is a character that cannot be seen: {name}." ["name" =@ nameOf (character c)]
  | otherwise = trWith "‘{character}’ looks like ‘{plain}’ and is another character: {name}." ["character" =: Text.singleton (character c), "plain" =: plain c, "name" =@ nameOf (character c)]
hintOf c
  | Text.null (plain c) = tr "Remove it."
  | plain c == "\"" = tr "Texts are written between straight quotation marks: \"hello\""
  | Text.null (within c) = trWith "Write: {code}" ["code" =: plain c]
  | otherwise = trWith "Write: {code}" ["code" =: latin (within c)]

-- | Whether a sign has no meaning of its own in the program: it defines no operator of that name, and no extension allows it.
isForeign :: Text -> Confusable -> Bool
isForeign source c = (Text.null (within c) || isFullWidth (character c)) && not (inText c) && not (("(" <> Text.singleton (character c) <> ")") `Text.isInfixOf` source) && not (character c `elem` ("→⇒←∷∀" :: String) && "UnicodeSyntax" `Text.isInfixOf` source)

-- | Whether a name has Latin letters as well.
isMixed :: Text -> Bool
isMixed name = Text.any (\c -> isAscii c && isAlphaNum c) name && Text.any (not . isAscii) name

-- | A name with the Latin letters that its letters look like.
latin :: Text -> Text
latin = Text.map (\c -> if isFullWidth c then halfWidth c else Map.findWithDefault c c letters)

-- | Warnings about characters that change the direction of the text, wherever they stand: what is shown is not what is read.
directionControls :: Text -> [Problem]
directionControls source =
  [ (problemAt s "direction" (trWith "A character that cannot be seen changes the direction of the text here: {name}." ["name" =@ nameOf c]) (tr "The program may be shown in another order than the one in which it is read. Remove it."))
      { severity = Warning,
        fixes = [Fix (tr "Remove it") [Edit s ""]]
      }
    | Text.any isDirection source,
      (l, text) <- zip [1 ..] (Text.splitOn "\n" source),
      (k, c) <- zip [1 ..] (Text.unpack text),
      isDirection c,
      let s = Span (Position l k) (Position l (k + 1))
  ]
  where
    isDirection c = c >= '\x202A' && c <= '\x202E' || c >= '\x2066' && c <= '\x2069'

-- | All of them outside of comments, in order; inside of texts only those that cannot be seen.
confusables :: Text -> [Confusable]
confusables source = if Text.all isAscii source then [] else go True (Position 1 1) (Text.unpack source)
  where
    go _ _ [] = []
    go _ p ('\n' : rest) = go True (Position (line p + 1) 1) rest
    go first p s@(c : rest)
      | isSpace c, c `notElem` ("\x2028\x2029\x85" :: String) = go first (move 1 p) rest
      | '-' : '-' : more <- s, not (continuesOperator more) = skipLine p s
      | '{' : '-' : _ <- s = let (n, more) = comment (1 :: Int) 2 (drop 2 s) in go False (advance p (take n s)) more
      | c == '"' = let (inside, more) = text rest in [Confusable q x "" "" True | (x, q) <- zip inside (places (move 1 p) inside), isUnseen x, not (isSpace x)] ++ go False (advance (move 1 p) inside) more
      | '\'' : x : '\'' : more <- s, x /= '\\' = go False (move 3 p) more
      | c `elem` ("—–" :: String), first = Confusable p c "--" "" False : skipLine p s
      | isDouble c, (inside, close : more) <- break (\x -> isDouble x || x == '"' || x == '\n') rest, isDouble close || close == '"' = Confusable p c "\"" "" False : [Confusable (move (1 + length inside) p) close "\"" "" False | isDouble close] ++ go False (move (2 + length inside) p) more
      | isDouble c = Confusable p c "\"" "" False : go False (move 1 p) rest
      | c == '‘', (inside, close : more) <- break (`elem` ("’‘\n" :: String)) rest, close /= '\n' = let quote = if length inside == 1 then "'" else "\"" in Confusable p c quote "" False : Confusable (move (1 + length inside) p) close quote "" False : go False (move (2 + length inside) p) more
      | isWord c = let w = takeWhile isWord s in [Confusable q x good (Text.pack w) False | (x, q) <- zip w (places p w), Just good <- [letterFor x]] ++ go False (move (length w) p) (drop (length w) s)
      | Just good <- signFor c = Confusable p c good "" False : go False (move 1 p) rest
      | otherwise = go False (move 1 p) rest
    -- A text up to its quotation mark or the end of the line, and what follows.
    text s = case s of
      [] -> ([], [])
      '\n' : _ -> ([], s)
      '\\' : x : rest -> let (inside, more) = text rest in ('\\' : x : inside, more)
      '"' : rest -> ("\"", rest)
      x : rest -> let (inside, more) = text rest in (x : inside, more)
    skipLine p s = let (inside, more) = break (== '\n') s in go False (move (length inside) p) more
    comment 0 n s = (n, s)
    comment d n s = case s of
      [] -> (n, [])
      '-' : '}' : rest -> comment (d - 1) (n + 2) rest
      '{' : '-' : rest -> comment (d + 1) (n + 2) rest
      _ : rest -> comment d (n + 1) rest
    continuesOperator (c : _) = c `elem` ("!#$%&*+./<=>?@\\^|~:" :: String)
    continuesOperator [] = False
    isWord c = isAlphaNum c || c == '_' || c == '\''
    isDouble c = c `elem` ("“”„‟«»‹›＂" :: String)
    move n p = p {column = column p + n}
    places = scanl (\p c -> advance p [c])
    advance = foldl (\p c -> if c == '\n' then Position (line p + 1) 1 else p {column = column p + 1})

-- | What is written for a sign.
signFor :: Char -> Maybe Text
signFor c
  | isFullWidth c = Just (Text.singleton (halfWidth c))
  | c `elem` ("\x2028\x2029\x85" :: String) = Just "\n"
  | isUnseen c = Just ""
  | otherwise = fst <$> Map.lookup c signs

letterFor :: Char -> Maybe Text
letterFor c
  | isFullWidth c = Just (Text.singleton (halfWidth c))
  | otherwise = Text.singleton <$> Map.lookup c letters

isUnseen :: Char -> Bool
isUnseen c = not (isAscii c) && (generalCategory c == Format || c >= '\xFE00' && c <= '\xFE0F' || c `elem` ("\x2028\x2029\x85" :: String))

-- | Unicode's block "Halfwidth and Fullwidth Forms": the printable characters of ASCII in the width of a Chinese character.
isFullWidth :: Char -> Bool
isFullWidth c = c >= '\xFF01' && c <= '\xFF5E'

halfWidth :: Char -> Char
halfWidth c = chr (ord c - 0xFEE0)

-- | The name of a character in Unicode, in words.
nameOf :: Char -> Sentence
nameOf c
  | isFullWidth c = trWith "the full-width {letter}" ["letter" =: Text.singleton (halfWidth c)]
  | Just (_, name) <- Map.lookup c signs = name
  | Just name <- Map.lookup c unseen = name
  | Map.member c letters = if c < '\x400' then trWith "the Greek letter {letter}" ["letter" =: Text.singleton c] else trWith "the Cyrillic letter {letter}" ["letter" =: Text.singleton c]
  | otherwise = trWith "the character U+{code}" ["code" =: Text.toUpper (Text.justifyRight 4 '0' (Text.pack (showHex (ord c) "")))]

-- | Letters that look Latin. Unicode Technical Standard 39, confusables.txt, those that keyboards have.
letters :: Map.Map Char Char
letters = Map.fromList (zip "аеорсухіјѕһԁԛԝАВЕКМНОРСТУХІЈЅ" "aeopcyxijshdqwABEKMHOPCTYXIJS" ++ zip "ονρυικαΑΒΕΖΗΙΚΜΝΟΡΤΥΧ" "ovpuikaABEZHIKMNOPTYX")

signs :: Map.Map Char (Text, Sentence)
signs =
  Map.fromList
    [ ('−', ("-", tr "minus sign")),
      ('‐', ("-", tr "hyphen")),
      ('‑', ("-", tr "non-breaking hyphen")),
      ('‒', ("-", tr "figure dash")),
      ('–', ("-", tr "en dash")),
      ('—', ("-", tr "em dash")),
      ('―', ("-", tr "horizontal bar")),
      ('×', ("*", tr "multiplication sign")),
      ('∗', ("*", tr "asterisk operator")),
      ('·', ("*", tr "middle dot")),
      ('⋅', ("*", tr "dot operator")),
      ('÷', ("/", tr "division sign")),
      ('∕', ("/", tr "division slash")),
      ('⁄', ("/", tr "fraction slash")),
      ('≤', ("<=", tr "less-than or equal to")),
      ('≥', (">=", tr "greater-than or equal to")),
      ('≠', ("/=", tr "not equal to")),
      ('…', ("..", tr "horizontal ellipsis")),
      ('∧', ("&&", tr "logical and")),
      ('∨', ("||", tr "logical or")),
      ('∶', (":", tr "ratio")),
      ('→', ("->", tr "rightwards arrow")),
      ('⇒', ("=>", tr "rightwards double arrow")),
      ('←', ("<-", tr "leftwards arrow")),
      ('∷', ("::", tr "proportion")),
      ('∀', ("forall", tr "for all")),
      ('“', ("\"", tr "left double quotation mark")),
      ('”', ("\"", tr "right double quotation mark")),
      ('„', ("\"", tr "double low-9 quotation mark")),
      ('‟', ("\"", tr "double high-reversed-9 quotation mark")),
      ('«', ("\"", tr "left-pointing double angle quotation mark")),
      ('»', ("\"", tr "right-pointing double angle quotation mark")),
      ('‹', ("\"", tr "single left-pointing angle quotation mark")),
      ('›', ("\"", tr "single right-pointing angle quotation mark")),
      ('‘', ("'", tr "left single quotation mark")),
      ('’', ("'", tr "right single quotation mark")),
      ('‚', ("'", tr "single low-9 quotation mark")),
      ('´', ("'", tr "acute accent")),
      ('′', ("'", tr "prime"))
    ]

unseen :: Map.Map Char Sentence
unseen =
  Map.fromList
    [ ('\xAD', tr "soft hyphen"),
      ('\x200B', tr "zero width space"),
      ('\x200C', tr "zero width non-joiner"),
      ('\x200D', tr "zero width joiner"),
      ('\x200E', tr "left-to-right mark"),
      ('\x200F', tr "right-to-left mark"),
      ('\x2028', tr "line separator"),
      ('\x2029', tr "paragraph separator"),
      ('\x202A', tr "left-to-right embedding"),
      ('\x202B', tr "right-to-left embedding"),
      ('\x202C', tr "pop directional formatting"),
      ('\x202D', tr "left-to-right override"),
      ('\x202E', tr "right-to-left override"),
      ('\x2060', tr "word joiner"),
      ('\x2066', tr "left-to-right isolate"),
      ('\x2067', tr "right-to-left isolate"),
      ('\x2068', tr "first strong isolate"),
      ('\x2069', tr "pop directional isolate"),
      ('\xFEFF', tr "zero width no-break space (byte order mark)")
    ]
