{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Kind.Slips
-- Description : Types that do not fit because of how something was written.
--
-- Behind some mismatches stands a slip that the text shows better than the types: a dot for a field, commas between arguments, a pattern without its
-- constructor. They are looked for before the types are compared.
module Rosy.Worker.Kind.Slips
  ( slip,
    halfBuilt,
    looseCalculation,
  )
where

import Data.Char (isAlphaNum, isDigit, isLower, isSpace, isUpper)
import Data.List (find, tails)
import Data.Maybe (fromMaybe, isNothing, listToMaybe, mapMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.Kind.Nouns (isNumber)
import Rosy.Worker.Kind.Words
import Rosy.Worker.Problem
import Rosy.Worker.Raw

-- | What was written instead of what was meant, if the text shows it. Takes the type that is needed and the one that is there.
slip :: Outline -> Raw -> (Text -> Text -> Text -> Problem) -> Type -> Type -> Maybe Problem
slip outline raw problem needed given = listToMaybe (concat [dotted, minus, pairPattern, commas, unfinished, joined, ofMain, inPattern, tasks])
  where
    source = region raw >>= snippet (text outline)
    lineAt s = maybe "" snd (find ((== line (start s)) . fst) (zip [1 ..] (Text.splitOn "\n" (text outline))))
    before = maybe "" (\s -> Text.take (column (start s) - 1) (lineAt s)) (region raw)
    behind = maybe "" (\s -> Text.drop (column (end s) - 1) (lineAt s)) (region raw)
    headOf t = fromMaybe "" (listToMaybe (atoms t))
    innerOf t = Text.unwords (drop 1 (atoms t))

    -- r.speed, where speed is a field.
    dotted =
      [ (problem "operator" "A value has no parts behind a dot." ("To take a field, write its name in front: " <> field <> " " <> owner <> ".")) {place = Just (Span (Place (line (start s)) from) (Place (line (start s)) upTo))}
        | Just s <- [region raw],
          (owner, field, from, upTo) <- dots (lineAt s),
          from <= column (end s),
          upTo >= column (start s),
          isField field
      ]
    isField f = any (\l -> any (`Text.isInfixOf` l) [f <> " ::", f <> "::"] && any (`Text.isInfixOf` l) ["{", ","]) (Text.lines (text outline))

    -- Velocity 0 -0.5, which GHC reads as a subtraction.
    minus =
      [ (problem "negative-number" "Here minus takes one thing from another." ("A negative number needs brackets: (-" <> n <> ").")) {place = Just (Span (Place (line (start s)) i) (Place (line (start s)) (i + 1)))}
        | isFunction given,
          not (isFunction needed),
          Just s <- [region raw],
          (left, right) <- take 1 (Text.breakOnAll " -" (lineAt s)),
          any (maybe False (isUpper . fst) . Text.uncons) (Text.words left),
          let n = Text.takeWhile (\c -> isDigit c || c == '.') (Text.drop 2 right),
          not (Text.null n),
          let i = Text.length left + 2
      ]

    -- drive (v, w) = …, where drive takes a Velocity.
    pairPattern =
      [ problem "pattern" ("This takes " <> a needed <> ", but the pattern is a pair.") ("Write the pattern as (" <> Text.unwords (needed : parts) <> ").")
        | isPattern,
          needed `elem` ["Velocity", "Position"],
          "(" `Text.isPrefixOf` given,
          Just s <- [source],
          Just inside <- [Text.stripPrefix "(" s >>= Text.stripSuffix ")"],
          let parts = map Text.strip (Text.splitOn "," inside),
          length parts == 2
      ]

    -- add(v, 0.5)
    commas =
      [ problem "arguments-with-commas" "Values stand behind a function without commas." ("Write: " <> Text.unwords (f : map argument parts) <> ".")
        | "(" `Text.isPrefixOf` given,
          "," `Text.isInfixOf` given,
          not ("(" `Text.isPrefixOf` needed),
          Just s <- [source],
          Just inside <- [Text.stripPrefix "(" s >>= Text.stripSuffix ")"],
          let parts = map Text.strip (Text.splitOn "," inside),
          not (any (Text.any (`elem` ("([" :: String))) parts),
          let f = Text.takeWhileEnd (\c -> isAlphaNum c || c `elem` ("_'" :: String)) (Text.stripEnd before),
          not (Text.null f)
      ]
    argument t = if Text.any isSpace t || "-" `Text.isPrefixOf` t then "(" <> t <> ")" else t

    -- Memory (Turn 1.5), where Turn needs one more.
    unfinished =
      [ missing c (init (splitArrows (stripped (innerOf given))))
        | headOf given == headOf needed,
          headOf given `elem` ["Memory", "Param", "Maybe", "Done"],
          let parts = splitArrows (stripped (innerOf given)),
          length parts > 1,
          last parts == stripped (innerOf needed),
          Just s <- [source],
          c : _ <- [drop 1 (Text.words (Text.filter (`notElem` ("()" :: String)) s))]
      ]
    missing c rest = problem "missing-argument" (quoted c <> " needs " <> (if length rest == 1 then "another value: " else "more values: ") <> Text.intercalate ", then " (map a rest) <> ".") "Add what is missing."
    stripped t = fromMaybe t (Text.stripPrefix "(" t >>= Text.stripSuffix ")")

    joined =
      [ problem "operator" ("‘++’ puts texts and lists together, but this is " <> a given <> ".") "To add numbers, write +."
        | "[" `Text.isPrefixOf` needed || needed == "String",
          isNumber given,
          any (`Text.isInfixOf` (" " <> before <> behind)) ["++"],
          "++" `Text.isPrefixOf` Text.stripStart behind && not ("\"" `Text.isInfixOf` behind)
      ]

    ofMain =
      [ (problem "main-type" "The type of ‘main’ is IO ()." "Write main :: IO (), or leave that line out.") {place = lookup "main" (signatures outline)}
        | "IO" == headOf given,
          "main" `elem` take 1 (Text.words (Text.stripStart before)),
          Just _ <- [lookup "main" (signatures outline)]
      ]

    -- Before the equals sign or the arrow of a case.
    isPattern = not (any (`elem` ["=", "->", "<-", "|"]) (Text.words before)) && any (`elem` ["=", "->", "|", "<-"]) (Text.words behind)
    inPattern =
      [ problem k m ("Write the pattern as (" <> c <> " " <> s' <> ").")
        | isPattern,
          (c, k, m) <- [("Memory", "missing-memory", "This takes a whole Memory, but the pattern is that of " <> a given <> "."), ("Just", "missing-just", "The type says that this may be missing, but the pattern does not.")],
          headOf needed == (if c == "Just" then "Maybe" else c),
          stripped (innerOf needed) == given,
          Just s <- [source],
          let s' = if Text.any isSpace s && not ("(" `Text.isPrefixOf` s) then "(" <> s <> ")" else s
      ]

    tasks
      | isFunction given, isFunction needed, w : _ <- filter (`elem` ["when", "unless"]) (Text.words line'), "()" `elem` map (last . splitArrows) [given, needed] = [(problem "too-many-arguments" (quoted w <> " takes two things: a condition and a task.") ("Put brackets around the task: " <> w <> " c (say \"yes\").")) {place = wordPlace w}]
      | source == Just "say", isFunction needed, input : _ <- splitArrows needed, input /= "String" = [problem "type-mismatch" ("‘say’ takes a text, but here it is given " <> a input <> ".") "Turn it into a text first: say . show."]
      | headOf given == "Task", isFunction needed, last (splitArrows needed) `elem` ["res", "see"] = [problem "controller-needed" "This is a task, but here is the place of a function that gives a command." "Write for example: \\_ -> Say \"done\"."]
      | openEnded, given `elem` ["Velocity", "Led1", "Led2", "Sound", "Say"] = [problem "task-needed" ("A task is needed here, but this is " <> a given <> ".") ("Turn a command into a task with once" <> maybe "" (\s -> ": once " <> argument s) source <> ".")]
      | headOf needed /= "Task" = []
      | given == "String" = [problem "task-needed" "A task is needed here, but this is a text." ("To show it, write say in front of it" <> maybe "" (": say " <>) source <> ".")]
      | "[Task" `Text.isPrefixOf` given = [problem "task-needed" "One task is needed here, but this is a list of them." "Take them out of the list; sequence_ makes one task of a list."]
      | given == "Call" = [problem "task-needed" "A task is needed here, but this is a ‘Call’." "In a task, write the called task itself, without call."]
      | otherwise = []

    -- f a, where nothing says more.
    openEnded = length (atoms needed) == 2 && maybe False (isLower . fst) (Text.uncons (headOf needed)) && not (isFunction needed)
    line' = maybe "" lineAt (region raw)
    wordPlace w = do
      s <- region raw
      let from = Text.length (fst (Text.breakOn (w <> " ") line')) + 1
      Just (Span (Place (line (start s)) from) (Place (line (start s)) (from + Text.length w)))

-- | The names on both sides of each dot of a line that touches both, and where that begins and ends.
dots :: Text -> [(Text, Text, Int, Int)]
dots l = mapMaybe at [i | (i, '.') <- zip [0 ..] (Text.unpack l)]
  where
    at i =
      let owner = Text.takeWhileEnd isName (Text.take i l)
          field = Text.takeWhile isName (Text.drop (i + 1) l)
          begins p t = maybe False (p . fst) (Text.uncons t)
       in if begins isLower owner && begins isLower field then Just (owner, field, i + 1 - Text.length owner, i + 2 + Text.length field) else Nothing
    isName c = isAlphaNum c || c `elem` ("_'" :: String)

-- | The constructor that a definition without a type consists of, if it takes nothing itself: as in @go = Velocity 0.5@.
halfBuilt :: Outline -> Text -> Maybe (Text, Span)
halfBuilt outline name = do
  s <- lookup name (bindings outline)
  if isNothing (lookup name (signatures outline)) then Just () else Nothing
  body <- snippetOf s
  rest <- Text.stripPrefix name body >>= Text.stripPrefix "=" . Text.stripStart
  c <- listToMaybe (Text.words rest)
  if maybe False (isUpper . fst) (Text.uncons c) then Just (c, s) else Nothing
  where
    snippetOf s
      | line (start s) == line (end s) = Just (Text.take (column (end s) - column (start s)) (Text.drop (column (start s) - 1) (Text.splitOn "\n" (text outline) !! (line (start s) - 1))))
      | otherwise = Nothing

-- | A constructor, and the calculation among its values that needs brackets: as in @Velocity 0 pi/2@ and @Velocity v * 2 0@. Where the sign
-- stands apart and all values are there, it may be the whole that is calculated with.
looseCalculation :: Text -> Maybe (Text, Text)
looseCalculation = listToMaybe . mapMaybe behind . tails . Text.words
  where
    behind ws = case ws of
      c : values | startsWith isUpper c, Text.all isAlphaNum c -> (,) c <$> listToMaybe (mapMaybe touching (takeWhile plain values) ++ apart (takeWhile plain values))
      _ -> Nothing
    touching w = case Text.break (`elem` signs) w of
      (x, more) | not (Text.null x), startsWith isValue (Text.drop 1 more) -> Just w
      _ -> Nothing
    apart values = case values of
      x : sign : y : _ | Text.length sign == 1, Text.all (`elem` signs) sign, startsWith isValue y -> [Text.unwords [x, sign, y]]
      _ -> []
    plain = Text.all (\c -> isAlphaNum c || c `elem` ("._'" :: String) || c `elem` signs)
    startsWith p = maybe False (p . fst) . Text.uncons
    isValue c = isLower c || isDigit c
    signs = "+*/" :: String
