{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Robots.Wording
-- Description : Sentences in the language of this machine's terminals.
--
-- In: a sentence, and the variables of the locale. Out: its text. The tables are in the executable ("Rosy.Robots.Translations"): a built program
-- runs on computers without Rosy. English has no table; @en_XA@ is English with accents, for tests: what still reads as English in it is in no
-- table. The service does the same with all sentences ("sim-service/rosy_sim/sentences/wording.py").
module Rosy.Robots.Wording
  ( -- * Terminal
    inTerminal,
    tellPerson,

    -- * Languages
    Language (..),
    languageOf,
    terminalLanguage,
    languages,
    worded,
  )
where

import Control.Monad (join)
import Data.Aeson (FromJSON (..), Object, Value (..), withObject, (.:))
import qualified Data.Aeson as Aeson
import qualified Data.Aeson.Key as Key
import qualified Data.Aeson.KeyMap as KeyMap
import qualified Data.ByteString.Char8 as C
import Data.Char (isLetter, toLower)
import Data.Foldable (toList)
import Data.List (find)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, mapMaybe)
import Data.Text (Text)
import qualified Data.Text as T
import Data.Text.Encoding (encodeUtf8)
import Rosy.Robots.Translations (tables)
import Rosy.Sentence (Sentence, english, isFunction, sentenceId)
import System.Environment (lookupEnv)
import System.IO (stderr)

-- | The sentence in the language of this machine's terminals.
inTerminal :: Sentence -> IO Text
inTerminal sentence = (`worded` sentence) <$> machineLanguage

-- | Prints the sentence to standard error. As UTF-8, whatever the handle's encoding: a letter that it lacks would be an exception while a robot
-- drives.
tellPerson :: Sentence -> IO ()
tellPerson sentence = inTerminal sentence >>= C.hPutStr stderr . encodeUtf8 . (<> "\n")

data Language
  = English
  | -- | English with accents, as Unicode's CLDR names the pseudo-locale
    Pseudo
  | -- | the tag of a table
    Translated Text
  deriving (Eq, Show)

-- | The language of a locale as POSIX names it: @pt_BR.UTF-8@ is @pt@.
languageOf :: String -> Language
languageOf locale
  | tag == "en-xa" = Pseudo
  | tag' <- takeWhile (/= '-') tag, Map.member (T.pack tag') known = Translated (T.pack tag')
  | otherwise = English
  where
    tag = map (toLower . \c -> if c == '_' then '-' else c) (takeWhile (`notElem` (".@" :: String)) locale)

-- | The language that the variables of the locale name: the first that is set and not empty (POSIX.1-2017, Base Definitions, section 8.2).
terminalLanguage :: (String -> Maybe String) -> Language
terminalLanguage variable = maybe English languageOf (find (not . null) (mapMaybe variable localeVariables))

-- | The first is what @./rosy@ found where it had to choose another encoding.
localeVariables :: [String]
localeVariables = ["ROSY_LOCALE", "LC_ALL", "LC_MESSAGES", "LANG"]

machineLanguage :: IO Language
machineLanguage = do
  values <- mapM (\name -> (,) name <$> lookupEnv name) localeVariables
  pure (terminalLanguage (\name -> join (lookup name values)))

-- | The tags of all tables.
languages :: [Text]
languages = Map.keys known

-- | What @languages/<tag>/sentences.json@ says: the forms of its language (protocol/README.md, section 1.1), and the translation of a template.
data Table = Table
  { ofType :: Text,
    ofFunction :: Text,
    alternative :: Text,
    sequence' :: Text,
    numberWords :: [Text],
    templateOf :: Text -> Maybe Text
  }

instance FromJSON Table where
  parseJSON = withObject "a table" $ \o -> do
    sentences <- o .: "sentences"
    Table <$> o .: "type" <*> o .: "function" <*> o .: "alternative" <*> o .: "sequence" <*> o .: "numbers" <*> pure (`Map.lookup` sentences)

known :: Map.Map Text Table
known = Map.fromList [(T.pack tag, table) | (tag, text) <- tables, Just table <- [Aeson.decodeStrict' (C.pack text)]]

pseudo :: Table
pseudo = Table "å ‘{type}’" "å ƒûñçţîöñ ‘{type}’" " öŕ " ", ţĥéñ " [] (Just . T.concat . map accented . pieces)
  where
    accented piece = case piece of
      Plain t -> T.map (\c -> fromMaybe c (lookup c (zip letters accents))) t
      Placeholder whole _ _ -> whole
    letters = ['a' .. 'z'] ++ ['A' .. 'Z']
    accents = "åƀçđéƒĝĥîĵķļɱñöþǫŕšţûṽŵẋýžÅƁÇĐÉƑĜĤÎĴĶĻṀÑÖÞǪŔŠŢÛṼŴẊÝŽ"

-- | The sentence in a language; in English where its table lacks it.
worded :: Language -> Sentence -> Text
worded language sentence = fromMaybe (english sentence) $ do
  table <- case language of
    English -> Nothing
    Pseudo -> Just pseudo
    Translated tag -> Map.lookup tag known
  Object o <- sentenceId sentence
  put table o

-- | A sentence as the wire carries it.
put :: Table -> Object -> Maybe Text
put table o = do
  String template <- KeyMap.lookup "id" o
  let given = case KeyMap.lookup "arguments" o of
        Just (Object named) -> named
        _ -> mempty
      filled piece = case piece of
        Plain t -> Just t
        Placeholder _ format name -> formatted table format <$> KeyMap.lookup (Key.fromText name) given
  if T.null template then plainText given else templateOf table template >>= fmap T.concat . mapM filled . pieces
  where
    plainText given = case KeyMap.lookup "text" given of
      Just (String t) -> Just t
      _ -> Nothing

data Piece
  = Plain Text
  | -- | as it stands there, its format, its name
    Placeholder Text Text Text

pieces :: Text -> [Piece]
pieces rest = case T.breakOn "{" rest of
  (before, "") -> [Plain before]
  (before, more)
    | (inside, end) <- T.breakOn "}" (T.drop 1 more),
      not (T.null end),
      Just (format, name) <- placeholder (T.splitOn " " inside) ->
      Plain before : Placeholder ("{" <> inside <> "}") format name : pieces (T.drop 1 end)
    | otherwise -> Plain (before <> "{") : pieces (T.drop 1 more)
  where
    placeholder found = case found of
      [name] | isName name -> Just ("", name)
      [format, name] | isName format, isName name -> Just (format, name)
      _ -> Nothing
    isName t = not (T.null t) && T.all isLetter t

formatted :: Table -> Text -> Value -> Text
formatted table format argument = case argument of
  String t -> if format == "a" then typed t else t
  Number n
    | format == "count", word : _ <- drop (round n) (numberWords table) -> word
    | otherwise -> T.pack (show (round n :: Int))
  Array values -> several [t | String t <- toList values]
  Object o -> fromMaybe (englishOf argument) (put table o)
  _ -> ""
  where
    typed t = T.replace "{type}" t ((if isFunction t then ofFunction else ofType) table)
    several names = case format of
      "then" -> T.intercalate (sequence' table) (map typed names)
      "or" -> choice (map (\n -> "‘" <> n <> "’") names)
      _ -> T.intercalate ", " names
    choice names = case reverse names of
      final : before@(_ : _) -> T.intercalate ", " (reverse before) <> alternative table <> final
      _ -> T.concat names
    englishOf value = case Aeson.fromJSON value of
      Aeson.Success sentence -> english sentence
      Aeson.Error _ -> ""
