{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Explanation.OriginalVocabulary
-- Description : Names of the original Rosy of 2019 and 2021 that have another form here: hints and rewritings.
--
-- Takes a name or the place of its use. rosy-hs/from-the-paper.md lists the differences. Pure.
module Rosy.Worker.Explanation.OriginalVocabulary
  ( originalNameHint,
    originalOptionsHint,
    originalNameFixes,
    oneTypeForTask,
  )
where

import Data.Char (isAlphaNum, isSpace)
import Data.Text (Text)
import qualified Data.Text as Text
import Rosy.Worker.Explanation.MessageText (textAt)
import Rosy.Worker.Explanation.Tokenizer (Token (..), tokenEnd, tokenize)
import Rosy.Worker.Problem
import Rosy.Worker.Sentence

-- | What to write in place of a name of 2019 or 2021.
originalNameHint :: Text -> Maybe Sentence
originalNameHint n = case lookup n replacements of
  Just e -> Just (trWith "Write {code} in its place." ["code" =: e])
  Nothing | n `elem` turtleNames -> Just (tr "There is no turtle here: programs drive a Kobuki.")
  Nothing -> lookup n advice
  where
    advice =
      [ ("Kobuki", tr "The robot is chosen where the program is started. Write: simulate f."),
        ("Turtlesim", tr "There is no turtle here: programs drive a Kobuki. Write: simulate f."),
        ("taskOpts", tr "Write: taskWith taskOptions {starting = …, stopped = …} f"),
        ("callOpts", tr "Write: callOptions {cancelOn = …, onFeedback = …, onEnd = …}"),
        ("Robot", tr "The robot is chosen where the program is started."),
        ("def", tr "Write taskOptions for a task, callOptions for a call."),
        ("subTask", tr "Feedback can have any type here: take it with onFeedback of callOptions."),
        ("getCurrentTime", tr "A function that needs the time takes Clock or Seconds."),
        ("getPOSIXTime", tr "A function that needs the time takes Seconds."),
        ("newStdGen", tr "A function that needs random numbers takes a StdGen."),
        ("getStdGen", tr "A function that needs random numbers takes a StdGen.")
      ]

-- | Names with what replaces them, of the same meaning.
replacements :: [(Text, Text)]
replacements =
  [ ("noInit", "()"),
    ("noCleanup", "()"),
    ("noCancel", "(\\Never -> Nothing)"),
    ("noFeedback", "(\\() -> ())"),
    ("noResponse", "(const ())"),
    ("CallOpts", "CallOptions"),
    ("TaskOpts", "TaskOptions"),
    ("control", "simulate"),
    ("Rechargesound", "RechargeSound"),
    ("bumperRightStatus", "bumperStatusRight"),
    ("Time", "Clock"),
    ("UTCTime", "Clock"),
    ("POSIXTime", "Seconds"),
    ("floorFloating", "(fromIntegral . floor)"),
    ("roundFloating", "(fromIntegral . round)"),
    ("ceilingFloating", "(fromIntegral . ceiling)"),
    ("quotBy", "(\\d n -> truncate (toRational n / toRational d))"),
    ("remBy", "(\\d n -> n - fromInteger (truncate (toRational n / toRational d)) * d)"),
    ("><", "`bimap`"),
    ("average", "(\\xs -> sum xs / fromIntegral (length xs))"),
    ("swap", "(\\(a, b) -> (b, a))"),
    ("fst4", "(\\(a, _, _, _) -> a)"),
    ("snd4", "(\\(_, b, _, _) -> b)"),
    ("thr4", "(\\(_, _, c, _) -> c)"),
    ("fou4", "(\\(_, _, _, d) -> d)")
  ]

-- | Names of Turtlesim, which has no replacement.
turtleNames :: [Text]
turtleNames = ["Turtle", "AnyTurtle", "SomeTurtle", "TurtleNumber", "IsTurtleNumber", "Background", "Pen", "turtleNumber", "someTurtle", "someTurtleNumber", "onTurtle", "spawn", "setPen", "teleportAbsolute", "teleportRelative"]

-- | The hint for a field of the original's options. Takes the text before it on its line.
originalOptionsHint :: Text -> Maybe Sentence
originalOptionsHint before
  | "taskOpts" `Text.isInfixOf` before = originalNameHint "taskOpts"
  | "callOpts" `Text.isInfixOf` before = originalNameHint "callOpts"
  | otherwise = Nothing

-- | Rewritings of the use of such a name at this place.
originalNameFixes :: Text -> Span -> [Fix]
originalNameFixes source s = case break ((== start s) . from) (tokenize source) of
  (before, here : _)
    | word here `elem` ["init", "cleanup", "cancel", "feedback", "response"],
      options : _ <- drop 1 (dropWhile ((/= "{") . word) (reverse before)),
      word options `elem` ["taskOpts", "callOpts"] ->
      originalNameFixes source (Span (from options) (tokenEnd options))
  (before, here : behind) -> case word here of
    name | name `elem` ["Kobuki", "Turtlesim"] -> [withoutRobot before here behind]
    "taskOpts" -> taskOptionsFirst before here behind
    "callOpts" -> [Fix (tr "Write callOptions") (Edit (Span (from here) (tokenEnd here)) "callOptions" : [Edit (Span (from t) (tokenEnd t)) n | (t, next) <- zip fields (drop 1 fields), word next == "=", Just n <- [lookup (word t) callFields]])]
      where
        fields = concat (group behind)
    name | Just e <- lookup name replacements -> [Fix (trWith "Write {code}" ["code" =: e]) [Edit s e]]
    _ -> []
  _ -> []
  where
    withoutRobot before here behind = Fix (tr "Remove the robot") [Edit (Span begin (maybe (tokenEnd lastOne) from rest)) ""]
      where
        (begin, inside) = case reverse before of
          t : _ | word t == "(" -> (from t, t : here : behind)
          _ -> (from here, here : behind)
        argument = concat (take 1 (atoms inside))
        lastOne = if null argument then here else last argument
        rest = case drop (length argument) inside of
          t : _ | line (from t) == line (from lastOne) -> Just t
          _ -> Nothing
    -- task f taskOpts {init = i}  becomes  taskWith taskOptions {starting = i} f
    taskOptionsFirst before here behind =
      [ Fix (tr "Write taskWith") [Edit (Span (from task) (tokenEnd task)) ("taskWith taskOptions" <> renamed options), Edit (Span (tokenEnd (last f)) (maybe (tokenEnd here) (tokenEnd . last) options')) ""]
        | task : f@(_ : _) <- [lastCall before]
      ]
      where
        options' = case group behind of
          g : _ -> Just g
          [] -> Nothing
        options = maybe "" (\g -> " " <> textAt source (Span (from (head' g)) (tokenEnd (last g)))) options'
        head' = foldr const here
    lastCall before = case break ((== "task") . word) (reverse before) of
      (inside, task : _) | length (atoms (reverse inside)) == 1 -> task : reverse inside
      _ -> []
    group behind = case behind of
      t : _ | word t == "{" -> take 1 (atoms behind)
      _ -> []
    callFields = [("cancel", "cancelOn"), ("feedback", "onFeedback"), ("response", "onEnd")]

-- | The fields of task options by their names here.
renamed :: Text -> Text
renamed options = Text.concat (go (Text.groupBy (\a b -> isName a == isName b) options))
  where
    go (w : rest)
      | Just n <- lookup w [("init", "starting"), ("cleanup", "stopped")], "=" `Text.isPrefixOf` Text.dropWhile isSpace (Text.concat (take 1 rest)) = n : go rest
      | otherwise = w : go rest
    go [] = []
    isName c = isAlphaNum c || c `elem` ("_'" :: String)

-- | Tokens in groups: a bracket with all that it holds, or one token.
atoms :: [Token] -> [[Token]]
atoms tokens = case tokens of
  [] -> []
  t : rest
    | word t `elem` ["(", "[", "{"] -> let (inside, behind) = closing (1 :: Int) rest in (t : inside) : atoms behind
    | otherwise -> [t] : atoms rest
  where
    closing _ [] = ([], [])
    closing n (t : rest)
      | word t `elem` ["(", "[", "{"] = more (n + 1)
      | word t `elem` [")", "]", "}"] = if n == 1 then ([t], rest) else more (n - 1)
      | otherwise = more n
      where
        more m = let (inside, behind) = closing m rest in (t : inside, behind)

-- | @Task () a@ of 2021 becomes @Task a@.
oneTypeForTask :: Text -> Span -> [Fix]
oneTypeForTask source s = case atoms (dropWhile ((/= start s) . from) (tokenize source)) of
  [task] : first@(begin : _) : (next : _) : _
    | word task == "Task", not (null first) -> [Fix (tr "Keep the type that it ends with") [Edit (Span (from begin) (from next)) ""]]
  _ -> []
