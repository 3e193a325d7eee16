-- |
-- Module      : Ros.Net.XmlRpc
-- Description : The part of XML-RPC that ROS nodes and masters speak.
--
-- In: the body of a request or a response. Out: a 'Call' or an 'Answer', and back. Peers differ in
-- white space, in @int@ or @i4@, and in leaving out @string@, so the reader is lenient: it knows tags and
-- text, not XML. Types as in <http://xmlrpc.com/spec.md>.
module Ros.Net.XmlRpc
  ( Value (..),
    Call (..),
    Answer (..),
    encodeCall,
    encodeAnswer,
    decodeCall,
    decodeAnswer,
    NotXmlRpc (..),
  )
where

import qualified Data.ByteString as B
import qualified Data.ByteString.Builder as B
import Data.Char (chr, isDigit, isHexDigit, isSpace)
import Data.List (dropWhileEnd, isPrefixOf)
import qualified Data.Text as T
import qualified Data.Text.Encoding as T
import qualified Data.Text.Encoding.Error as T
import Numeric (readHex)
import Text.Read (readMaybe)

data Value
  = VInt Int
  | VBool Bool
  | VDouble Double
  | VString String
  | VArray [Value]
  | VStruct [(String, Value)]
  | -- | base64 text, kept as it came: no ROS call uses it, but a parameter may hold it
    VBinary String
  deriving (Eq, Show)

data Call = Call String [Value]
  deriving (Eq, Show)

data Answer
  = Answer Value
  | -- | what the other side said when it could not answer at all
    Fault String
  deriving (Eq, Show)

-- | What was expected, and where the text went another way.
data NotXmlRpc = NotXmlRpc String String
  deriving (Eq, Show)

encodeCall :: Call -> B.Builder
encodeCall (Call method params) =
  prologue <> el "methodCall" (el "methodName" (text method) <> el "params" (foldMap (el "param" . value) params))

encodeAnswer :: Answer -> B.Builder
encodeAnswer (Answer v) = prologue <> el "methodResponse" (el "params" (el "param" (value v)))
encodeAnswer (Fault why) =
  prologue <> el "methodResponse" (el "fault" (value (VStruct [("faultCode", VInt 1), ("faultString", VString why)])))

prologue :: B.Builder
prologue = B.string7 "<?xml version=\"1.0\"?>\n"

el :: String -> B.Builder -> B.Builder
el tag inner = B.string7 ('<' : tag) <> B.char7 '>' <> inner <> B.string7 "</" <> B.string7 tag <> B.char7 '>'

value :: Value -> B.Builder
value v = el "value" $ case v of
  VInt i -> el "int" (B.intDec i)
  VBool b -> el "boolean" (B.char7 (if b then '1' else '0'))
  VDouble d -> el "double" (B.string7 (show d))
  VString s -> el "string" (text s)
  VArray vs -> el "array" (el "data" (foldMap value vs))
  VStruct ms -> el "struct" (foldMap (\(k, m) -> el "member" (el "name" (text k) <> value m)) ms)
  VBinary s -> el "base64" (text s)

text :: String -> B.Builder
text = foldMap escape
  where
    escape c = case c of
      '<' -> B.string7 "&lt;"
      '>' -> B.string7 "&gt;"
      '&' -> B.string7 "&amp;"
      _ -> B.charUtf8 c

decodeCall :: B.ByteString -> Either NotXmlRpc Call
decodeCall body = do
  (method, rest) <- open "methodCall" (tokens body) >>= open "methodName" >>= textUntil "methodName"
  params <- case dropSpace rest of
    Open "params" : inner -> readParams (dropSpace inner)
    _ -> Right []
  pure (Call (trim method) params)

decodeAnswer :: B.ByteString -> Either NotXmlRpc Answer
decodeAnswer body = do
  inner <- open "methodResponse" (tokens body)
  case dropSpace inner of
    Open "fault" : rest -> do
      (v, _) <- readValue rest
      pure . Fault $ case v of
        VStruct ms | Just (VString why) <- lookup "faultString" ms -> why
        _ -> show v
    Open "params" : rest ->
      readParams (dropSpace rest) >>= \vs -> case vs of
        [v] -> Right (Answer v)
        _ -> Left (NotXmlRpc "one answer" (show (length vs)))
    other -> unexpected "params or fault" other

data Token = Open String | Close String | Text String
  deriving (Eq, Show)

-- | Tags and text. Comments, processing instructions and attributes disappear.
tokens :: B.ByteString -> [Token]
tokens = go . T.unpack . T.decodeUtf8With T.lenientDecode
  where
    go s
      | null s = []
      | "<?" `isPrefixOf` s = go (after "?>" s)
      | "<!--" `isPrefixOf` s = go (after "-->" s)
      | "<![CDATA[" `isPrefixOf` s = let (t, rest) = upTo "]]>" (drop 9 s) in Text t : go rest
      | "<!" `isPrefixOf` s = go (after ">" s)
      | "</" `isPrefixOf` s = let (t, rest) = upTo ">" (drop 2 s) in Close (trim t) : go rest
      | "<" `isPrefixOf` s =
        let (t, rest) = upTo ">" (drop 1 s)
            tag = takeWhile (\c -> not (isSpace c) && c /= '/') t
         in Open tag : [Close tag | drop (length t - 1) t == "/"] ++ go rest
      | otherwise = let (t, rest) = break (== '<') s in Text (unescape t) : go rest
    after mark = snd . upTo mark
    upTo mark s
      | null s = ("", "")
      | mark `isPrefixOf` s = ("", drop (length mark) s)
      | otherwise = let (t, rest) = upTo mark (drop 1 s) in (take 1 s ++ t, rest)

unescape :: String -> String
unescape s = case break (== '&') s of
  (t, '&' : rest) | (name, ';' : more) <- break (== ';') rest, Just c <- entity name -> t ++ c : unescape more
  (t, '&' : rest) -> t ++ '&' : unescape rest
  (t, _) -> t
  where
    entity name = case name of
      "lt" -> Just '<'
      "gt" -> Just '>'
      "amp" -> Just '&'
      "quot" -> Just '"'
      "apos" -> Just '\''
      '#' : 'x' : h@(_ : _) | all isHexDigit h, length h < 7, [(n, "")] <- readHex h -> character n
      '#' : d@(_ : _) | all isDigit d, length d < 8 -> character (read d)
      _ -> Nothing
    character n = if n <= 0x10FFFF then Just (chr n) else Nothing

readParams :: [Token] -> Either NotXmlRpc [Value]
readParams ts = case dropSpace ts of
  Open "param" : rest -> do
    (v, more) <- readValue rest
    close "param" more >>= fmap (v :) . readParams
  Close "params" : _ -> Right []
  other -> unexpected "param" other

-- | From @<value>@ to behind @</value>@.
readValue :: [Token] -> Either NotXmlRpc (Value, [Token])
readValue ts = do
  inner <- open "value" ts
  case inner of
    Close "value" : rest -> Right (VString "", rest)
    Text t : Close "value" : rest -> Right (VString t, rest)
    _ -> do
      (v, rest) <- typed (dropSpace inner)
      (,) v <$> close "value" rest

typed :: [Token] -> Either NotXmlRpc (Value, [Token])
typed ts = case ts of
  Open t : rest
    | t `elem` ["int", "i4", "i8"] -> parsed t (fmap VInt . readMaybe . dropPlus) rest
    | t == "boolean" -> parsed t (\s -> Just (VBool (s `elem` ["1", "true"]))) rest
    | t == "double" -> parsed t (fmap VDouble . readDouble) rest
    | t == "string" -> textUntil t rest >>= \(s, more) -> Right (VString s, more)
    | t `elem` ["base64", "dateTime.iso8601"] -> textUntil t rest >>= \(s, more) -> Right (VBinary (trim s), more)
    | t == "nil" -> close t rest >>= \more -> Right (VString "", more)
    | t == "array" -> do
      (vs, more) <- open "data" rest >>= elements
      (,) (VArray vs) <$> close "array" more
    | t == "struct" -> members rest
  other -> unexpected "a type" other
  where
    parsed tag f rest = do
      (s, more) <- textUntil tag rest
      maybe (Left (NotXmlRpc tag s)) (\v -> Right (v, more)) (f (trim s))
    dropPlus s = if take 1 s == "+" then drop 1 s else s

elements :: [Token] -> Either NotXmlRpc ([Value], [Token])
elements ts = case dropSpace ts of
  Close "data" : rest -> Right ([], rest)
  more -> do
    (v, rest) <- readValue more
    (vs, end) <- elements rest
    Right (v : vs, end)

members :: [Token] -> Either NotXmlRpc (Value, [Token])
members = go []
  where
    go seen ts = case dropSpace ts of
      Close "struct" : rest -> Right (VStruct (reverse seen), rest)
      Open "member" : rest -> do
        (k, afterName) <- open "name" rest >>= textUntil "name"
        (v, afterValue) <- readValue afterName
        close "member" afterValue >>= go ((k, v) : seen)
      other -> unexpected "member" other

open, close :: String -> [Token] -> Either NotXmlRpc [Token]
open tag ts = case dropSpace ts of
  Open t : rest | t == tag -> Right rest
  other -> unexpected ('<' : tag ++ ">") other
close tag ts = case dropSpace ts of
  Close t : rest | t == tag -> Right rest
  other -> unexpected ("</" ++ tag ++ ">") other

textUntil :: String -> [Token] -> Either NotXmlRpc (String, [Token])
textUntil tag = go ""
  where
    go seen ts = case ts of
      Text t : rest -> go (seen ++ t) rest
      Close t : rest | t == tag -> Right (seen, rest)
      other -> unexpected ("</" ++ tag ++ ">") other

unexpected :: String -> [Token] -> Either NotXmlRpc a
unexpected what ts = Left (NotXmlRpc what (show (take 2 ts)))

dropSpace :: [Token] -> [Token]
dropSpace = dropWhile blank
  where
    blank (Text t) = all isSpace t
    blank _ = False

-- | C's spelling too: @.5@, @1.@, @1e3@, @inf@, @nan@.
readDouble :: String -> Maybe Double
readDouble s = case s of
  '-' : rest -> negate <$> positive rest
  '+' : rest -> positive rest
  _ -> positive s
  where
    positive t
      | t `elem` ["inf", "Infinity"] = Just (1 / 0)
      | t `elem` ["nan", "NaN"] = Just (0 / 0)
      | otherwise =
        let (whole, rest) = span isDigit t
            (fraction, power) = case rest of
              '.' : more -> span isDigit more
              _ -> ("", rest)
         in if null whole && null fraction
              then Nothing
              else readMaybe (pad whole ++ "." ++ pad fraction ++ exponentOf power)
    pad d = if null d then "0" else d
    exponentOf e = case e of
      c : '+' : d | c `elem` "eE" -> 'e' : d
      c : d | c `elem` "eE" -> 'e' : d
      _ -> e

trim :: String -> String
trim = dropWhileEnd isSpace . dropWhile isSpace
