{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Sentence
-- Description : Translatable sentences: a template with named arguments.
--
-- The English template is the id of a sentence, as in gettext: English stands where the sentence is made, the other languages in
-- @languages/<tag>/sentences.json@. The wire carries the id, its arguments and the English text. "scripts/sentences.py" reads the templates
-- from the source text, which is why 'tr' and 'trWith' take a literal; it checks them against their arguments and against the tables.
--
-- A placeholder is @{name}@, or @{format name}@ with a format of protocol/README.md, section 1.1. All other text stands for itself, single
-- braces too. Pure.
module Rosy.Sentence
  ( -- * Making one
    Sentence,
    tr,
    trWith,
    verbatim,
    Argument,
    (=:),
    (=#),
    (=*),
    (=@),

    -- * Using one
    english,
    withArticle,
    isFunction,
    sentenceId,
    portable,
    fromPortable,
  )
where

import Control.Applicative ((<|>))
import Data.Aeson (FromJSON (..), ToJSON (..), Value, object, withObject, (.!=), (.:), (.:?), (.=))
import qualified Data.Aeson as Aeson
import qualified Data.Aeson.Key as Key
import qualified Data.Aeson.KeyMap as KeyMap
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (isLetter)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text

-- | A sentence for people: an English template of the tables with its arguments, or a text that is the same in every language.
data Sentence
  = Template !Text [(Text, Argument)]
  | Verbatim !Text
  deriving (Eq, Show)

-- | A piece of the program or of a message that stands in a sentence.
data Argument = Phrase !Text | Count !Int | Several [Text] | Nested !Sentence
  deriving (Eq, Show)

infix 4 =:, =#, =*, =@

-- | A name and the text for it.
(=:) :: Text -> Text -> (Text, Argument)
k =: v = (k, Phrase v)

-- | A name and the number for it.
(=#) :: Text -> Int -> (Text, Argument)
k =# v = (k, Count v)

-- | A name and the texts for it.
(=*) :: Text -> [Text] -> (Text, Argument)
k =* v = (k, Several v)

-- | A name and the sentence for it.
(=@) :: Text -> Sentence -> (Text, Argument)
k =@ v = (k, Nested v)

-- | A sentence without arguments.
tr :: Text -> Sentence
tr t = Template t []

-- | A sentence with a value for each placeholder.
trWith :: Text -> [(Text, Argument)] -> Sentence
trWith = Template

-- | A text that has no translation: a compiler's words, or nothing.
verbatim :: Text -> Sentence
verbatim = Verbatim

-- | The sentence in English.
english :: Sentence -> Text
english (Verbatim t) = t
english (Template t given) = Text.concat (pieces t)
  where
    pieces rest = case Text.breakOn "{" rest of
      (before, "") -> [before]
      (before, more)
        | (inside, end) <- Text.breakOn "}" (Text.drop 1 more),
          not (Text.null end),
          Just said <- placeholder (Text.splitOn " " inside) ->
          before : said : pieces (Text.drop 1 end)
        | otherwise -> before : "{" : pieces (Text.drop 1 more)
    placeholder ws = case ws of
      [name] | isName name -> formatted "" <$> lookup name given
      [format, name] | isName format, isName name -> formatted format <$> lookup name given
      _ -> Nothing
    isName w = not (Text.null w) && Text.all isLetter w

-- | An argument in an English sentence.
formatted :: Text -> Argument -> Text
formatted format argument = case (format, argument) of
  ("a", Phrase t) -> withArticle t
  ("or", Several ts) -> alternatives ts
  ("then", Several ts) -> Text.intercalate ", then " (map withArticle ts)
  ("count", Count n) -> number n
  (_, Phrase t) -> t
  (_, Count n) -> Text.pack (show n)
  (_, Several ts) -> Text.intercalate ", " ts
  (_, Nested s) -> english s

-- | A type with its article: a ‘Velocity’, an ‘Int’, a function ‘Bumper -> Sound’.
withArticle :: Text -> Text
withArticle t
  | isFunction t = "a function " <> quoted t
  | Just (c, _) <- Text.uncons t, c `elem` ("AEIO" :: String) = "an " <> quoted t
  | otherwise = "a " <> quoted t

-- | Whether an arrow stands outside of all brackets. A constraint before it does not count.
isFunction :: Text -> Bool
isFunction = go (0 :: Int) . withoutConstraint
  where
    withoutConstraint t = case Text.breakOn "=>" t of
      (_, rest) | not (Text.null rest) -> Text.drop 2 rest
      _ -> t
    go depth t = case Text.uncons t of
      Nothing -> False
      Just (c, rest)
        | depth == 0, "->" `Text.isPrefixOf` t -> True
        | c `elem` ("([" :: String) -> go (depth + 1) rest
        | c `elem` (")]" :: String) -> go (depth - 1) rest
        | otherwise -> go depth rest

-- | ‘a’, ‘b’ or ‘c’.
alternatives :: [Text] -> Text
alternatives xs = case reverse (map quoted xs) of
  [] -> ""
  [x] -> x
  x : others -> Text.intercalate ", " (reverse others) <> " or " <> x

quoted :: Text -> Text
quoted t = "‘" <> t <> "’"

number :: Int -> Text
number n = case drop n ["none", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"] of
  w : _ | n >= 0 -> w
  _ -> Text.pack (show n)

-- | The id with its arguments for the wire; nothing for a text that has no translation.
sentenceId :: Sentence -> Maybe Value
sentenceId (Verbatim _) = Nothing
sentenceId s = Just (toJSON s)

instance ToJSON Argument where
  toJSON (Phrase t) = toJSON t
  toJSON (Count n) = toJSON n
  toJSON (Several ts) = toJSON ts
  toJSON (Nested (Verbatim t)) = toJSON t
  toJSON (Nested s) = toJSON s

instance FromJSON Argument where
  parseJSON v = Phrase <$> parseJSON v <|> Count <$> parseJSON v <|> Several <$> parseJSON v <|> Nested <$> parseJSON v

-- | A text without translation is a sentence with an empty id.
instance ToJSON Sentence where
  toJSON s = case s of
    Verbatim t -> object ["id" .= ("" :: Text), "arguments" .= object ["text" .= t]]
    Template t given -> object (("id" .= t) : ["arguments" .= object [Key.fromText k .= v | (k, v) <- given] | not (null given)])

instance FromJSON Sentence where
  parseJSON = withObject "a sentence" $ \o -> do
    template <- o .: "id"
    given <- o .:? "arguments" .!= mempty
    pure $ case (template, KeyMap.lookup "text" given) of
      ("", Just (Phrase t)) -> Verbatim t
      _ -> Template template [(Key.toText k, v) | (k, v) <- KeyMap.toList given]

-- | A sentence as text, for a place where a 'Sentence' of this copy of the module cannot be passed.
portable :: Sentence -> String
portable = Text.unpack . Text.decodeUtf8 . Lazy.toStrict . Aeson.encode

-- | The sentence of such a text; any other text stands for itself.
fromPortable :: String -> Sentence
fromPortable text = case Aeson.decodeStrict' (Text.encodeUtf8 (Text.pack text)) of
  Just s -> s
  Nothing -> Verbatim (Text.pack text)
