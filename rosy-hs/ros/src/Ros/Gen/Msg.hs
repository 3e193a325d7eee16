-- |
-- Module      : Ros.Gen.Msg
-- Description : The text of a @.msg@ file as a value.
--
-- In: the text of one message definition. Out: its constants and fields in order, or the line that
-- could not be read. The format is described at <http://wiki.ros.org/msg>; where that page and
-- genmsg's @msg_loader.py@ differ, this follows genmsg, which is what every other node uses.
module Ros.Gen.Msg
  ( -- * What it is
    Msg (..),
    MsgName (..),
    Constant (..),
    Field (..),
    FieldType (..),
    Builtin (..),
    Count (..),
    fullName,
    builtinName,

    -- * Making one
    readMsg,
    readMsgName,

    -- * What can go wrong
    MsgError (..),
    explainMsgError,
  )
where

import Data.Char (isAlpha, isAlphaNum, isDigit, isSpace)
import Data.List (dropWhileEnd, find)

-- | @geometry_msgs/Twist@.
data MsgName = MsgName {package :: String, base :: String}
  deriving (Eq, Ord, Show)

fullName :: MsgName -> String
fullName (MsgName p b) = p ++ "/" ++ b

data Msg = Msg
  { msgName :: MsgName,
    constants :: [Constant],
    fields :: [Field],
    -- | the text as it was read: the MD5 sum ignores it, but it travels in the connection header
    source :: String
  }
  deriving (Eq, Show)

-- | @uint8 PRESSED=1@. The text of the value is kept: it enters the MD5 sum with its leading zeros.
data Constant = Constant {constantType :: Builtin, constantName :: String, constantText :: String}
  deriving (Eq, Show)

data Field = Field {fieldType :: FieldType, fieldCount :: Count, fieldName :: String}
  deriving (Eq, Show)

data FieldType = Builtin Builtin | Nested MsgName
  deriving (Eq, Ord, Show)

data Count = One | Many | Exactly Int
  deriving (Eq, Show)

data Builtin
  = TBool
  | TInt8
  | TUInt8
  | TInt16
  | TUInt16
  | TInt32
  | TUInt32
  | TInt64
  | TUInt64
  | TFloat32
  | TFloat64
  | TString
  | TTime
  | TDuration
  | TByte
  | TChar
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | As the definition language spells it.
builtinName :: Builtin -> String
builtinName b = case b of
  TBool -> "bool"
  TInt8 -> "int8"
  TUInt8 -> "uint8"
  TInt16 -> "int16"
  TUInt16 -> "uint16"
  TInt32 -> "int32"
  TUInt32 -> "uint32"
  TInt64 -> "int64"
  TUInt64 -> "uint64"
  TFloat32 -> "float32"
  TFloat64 -> "float64"
  TString -> "string"
  TTime -> "time"
  TDuration -> "duration"
  TByte -> "byte"
  TChar -> "char"

data MsgError
  = -- | A line that is neither a field nor a constant; number and text.
    StrangeLine Int String
  | -- | A type that is no builtin and no message name.
    StrangeType Int String
  | -- | A constant of a type that has none (a message, an array, a time).
    StrangeConstant Int String
  | -- | Not @package/Name@.
    StrangeName String
  deriving (Eq, Show)

explainMsgError :: MsgError -> String
explainMsgError e = case e of
  StrangeLine n t -> "line " ++ show n ++ " is neither a field nor a constant: " ++ t
  StrangeType n t -> "line " ++ show n ++ " uses a type that does not exist: " ++ t
  StrangeConstant n t -> "line " ++ show n ++ " gives a value to a type that has no constants: " ++ t
  StrangeName t -> "a message is named package/Name, not " ++ t

readMsgName :: String -> Either MsgError MsgName
readMsgName t = case break (== '/') t of
  (p, '/' : b) | isName p, isName b -> Right (MsgName p b)
  _ -> Left (StrangeName t)

readMsg :: MsgName -> String -> Either MsgError Msg
readMsg name text = build <$> traverse (uncurry (readLine name)) meaningful
  where
    meaningful = [(n, l) | (n, l) <- zip [1 ..] (lines text), not (null (strip (uncomment l)))]
    build parts = Msg name [c | Left c <- parts] [f | Right f <- parts] text

-- | One line: @float64[36] covariance@, @uint8 PRESSED=1  # held down@, @string NAME=anything # goes@.
readLine :: MsgName -> Int -> String -> Either MsgError (Either Constant Field)
readLine name n l
  | '=' `elem` uncomment l = Left <$> readConstant n l
  | otherwise = case words (uncomment l) of
    [t, f] | isName f -> Right <$> readField name n t f
    _ -> Left (StrangeLine n l)

readConstant :: Int -> String -> Either MsgError Constant
readConstant n l = case find ((== t) . builtinName) [minBound ..] of
  Just TString -> Right (Constant TString (constant l) (value l)) -- a string runs to the end, '#' included
  Just b | b /= TTime, b /= TDuration -> Right (Constant b (constant (uncomment l)) (value (uncomment l)))
  _ -> Left (StrangeConstant n l)
  where
    t = takeWhile (not . isSpace) (dropWhile isSpace l)
    constant = strip . takeWhile (/= '=') . dropWhile (not . isSpace) . dropWhile isSpace
    value = strip . drop 1 . dropWhile (/= '=')

readField :: MsgName -> Int -> String -> String -> Either MsgError Field
readField name n t f = do
  (elementType, count) <- case break (== '[') t of
    (b, "") -> Right (b, One)
    (b, "[]") -> Right (b, Many)
    (b, '[' : rest) | (digits@(_ : _), "]") <- span isDigit rest -> Right (b, Exactly (read digits))
    _ -> Left (StrangeType n t)
  whole <- maybe (Left (StrangeType n t)) Right (resolve elementType)
  Right (Field whole count f)
  where
    resolve b
      | Just known <- find ((== b) . builtinName) [minBound ..] = Just (Builtin known)
      | b == "Header" = Just (Nested (MsgName "std_msgs" "Header"))
      | isName b = Just (Nested (MsgName (package name) b))
      | otherwise = either (const Nothing) (Just . Nested) (readMsgName b)

uncomment :: String -> String
uncomment = takeWhile (/= '#')

strip :: String -> String
strip = dropWhileEnd isSpace . dropWhile isSpace

isName :: String -> Bool
isName (c : cs) = isAlpha c && all (\x -> isAlphaNum x || x == '_') cs
isName [] = False
