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
    ConstantValue (..),
    constantValue,

    -- * Making one
    readMsg,
    readMsgName,
    readSrv,
    halves,

    -- * What can go wrong
    MsgError (..),
    explainMsgError,
  )
where

import Data.Char (isAlpha, isAlphaNum, isDigit, isSpace, toLower)
import Data.List (dropWhileEnd, find, nub, (\\))

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
  | -- | A constant whose value is none of its type: not a number, or too large for it.
    StrangeValue Int String
  | -- | Two fields of this name.
    DuplicateField String
  | -- | Not @package/Name@.
    StrangeName String
  deriving (Eq, Show)

explainMsgError :: MsgError -> String
explainMsgError e = case e of
  StrangeLine n t -> "line " ++ show n ++ " is neither a field nor a constant: " ++ t
  StrangeType n t -> "line " ++ show n ++ " uses a type that does not exist: " ++ t
  StrangeConstant n t -> "line " ++ show n ++ " gives a value to a type that has no constants: " ++ t
  StrangeValue n t -> "line " ++ show n ++ " gives a constant a value that its type does not have: " ++ t
  DuplicateField t -> "two fields are named " ++ t
  StrangeName t -> "a message is named package/Name, not " ++ t

readMsgName :: String -> Either MsgError MsgName
readMsgName t = case break (== '/') t of
  (p, '/' : b) | isName p, isName b -> Right (MsgName p b)
  _ -> Left (StrangeName t)

readMsg :: MsgName -> String -> Either MsgError Msg
readMsg name text = traverse (uncurry (readLine name)) meaningful >>= distinct . build
  where
    distinct m = case names \\ nub names of
      twice : _ -> Left (DuplicateField twice)
      [] -> Right m
      where
        names = map fieldName (fields m)
    meaningful = [(n, l) | (n, l) <- zip [1 ..] (lines text), not (null (strip (uncomment l)))]
    build parts = Msg name [c | Left c <- parts] [f | Right f <- parts] text

-- | The messages of a service: what is asked and what is answered. A line that begins with @---@ stands between them.
readSrv :: MsgName -> String -> Either MsgError (Msg, Msg)
readSrv name text = (,) <$> readMsg request (ended above) <*> readMsg response (ended (filter (not . isBorder) below))
  where
    (request, response) = halves name
    (above, below) = break isBorder (split text)
    isBorder = (== "---") . take 3
    -- As genmsg: each part has a line break more than its lines, which the definition keeps.
    ended = unlines
    split t = case break (== '\n') t of
      (l, _ : rest) -> l : split rest
      (l, []) -> [l]

-- | The names of a service's two messages.
halves :: MsgName -> (MsgName, MsgName)
halves (MsgName p b) = (MsgName p (b ++ "Request"), MsgName p (b ++ "Response"))

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
  Just b
    | b /= TTime,
      b /= TDuration ->
      let c = Constant b (constant (uncomment l)) (value (uncomment l))
       in maybe (Left (StrangeValue n l)) (const (Right c)) (constantValue c)
  _ -> Left (StrangeConstant n l)
  where
    t = takeWhile (not . isSpace) (dropWhile isSpace l)
    constant = strip . takeWhile (/= '=') . dropWhile (not . isSpace) . dropWhile isSpace
    value = strip . drop 1 . dropWhile (/= '=')

-- | What a constant is worth. The texts are those that genmsg accepts: Python's @int()@ and @float()@, and for a truth value a literal.
data ConstantValue
  = Truth Bool
  | Whole Integer
  | -- | Sign, digits before and behind the point, exponent.
    Decimal Bool String String Integer
  | -- | Negative or not.
    Infinite Bool
  | NotANumber
  | Text String
  deriving (Eq, Show)

constantValue :: Constant -> Maybe ConstantValue
constantValue (Constant t _ v) = case t of
  TString -> Just (Text v)
  TBool
    | v == "True" -> Just (Truth True)
    | v == "False" -> Just (Truth False)
    | otherwise -> Truth . (/= 0) <$> whole v
  _
    | t `elem` [TFloat32, TFloat64] -> let (negative, rest) = signed v in real negative (map toLower rest)
    | otherwise -> Whole <$> (whole v >>= within (integerRange t))
  where
    whole :: String -> Maybe Integer
    whole text = let (negative, rest) = signed text in (if negative then negate else id) . read <$> digits rest
    within (low, high) n = if n >= low && n <= high then Just n else Nothing
    real negative text
      | text `elem` ["inf", "infinity"] = Just (Infinite negative)
      | text == "nan" = Just NotANumber
      | otherwise = do
        let (mantissa, e) = break (== 'e') text
            (before, point) = break (== '.') mantissa
            behind = drop 1 point
        exponent' <- if null e then Just 0 else whole (drop 1 e)
        if null before && null behind then Nothing else Decimal negative <$> part before <*> part behind <*> Just exponent'
    part text = if null text then Just "" else digits text

-- | Without a sign in front, and whether it was a minus.
signed :: String -> (Bool, String)
signed text = case text of
  '-' : rest -> (True, rest)
  '+' : rest -> (False, rest)
  _ -> (False, text)

-- | The digits of a number; Python allows single underscores between them.
digits :: String -> Maybe String
digits text = case span isDigit text of
  (ds@(_ : _), "") -> Just ds
  (ds@(_ : _), '_' : rest) -> (ds ++) <$> digits rest
  _ -> Nothing

integerRange :: Builtin -> (Integer, Integer)
integerRange t = case t of
  TInt8 -> twos 8
  TByte -> twos 8
  TInt16 -> twos 16
  TInt32 -> twos 32
  TInt64 -> twos 64
  TUInt16 -> (0, 2 ^ (16 :: Int) - 1)
  TUInt32 -> (0, 2 ^ (32 :: Int) - 1)
  TUInt64 -> (0, 2 ^ (64 :: Int) - 1)
  _ -> (0, 255)
  where
    twos :: Int -> (Integer, Integer)
    twos bits = (negate (2 ^ (bits - 1)), 2 ^ (bits - 1) - 1)

readField :: MsgName -> Int -> String -> String -> Either MsgError Field
readField name n t f = do
  (elementType, count) <- case break (== '[') t of
    (b, "") -> Right (b, One)
    (b, "[]") -> Right (b, Many)
    (b, '[' : rest) | (size@(_ : _), "]") <- span isDigit rest -> Right (b, Exactly (read size))
    _ -> Left (StrangeType n t)
  whole <- maybe (Left (StrangeType n t)) Right (resolve count elementType)
  Right (Field whole count f)
  where
    resolve count b
      | Just known <- find ((== b) . builtinName) [minBound ..] = Just (Builtin known)
      -- As in genmsg: an array of Header is of the Header of the package.
      | b == "Header", count == One = Just (Nested (MsgName "std_msgs" "Header"))
      | isName b = Just (Nested (MsgName (package name) b))
      | otherwise = either (const Nothing) (Just . Nested) (readMsgName b)

uncomment :: String -> String
uncomment = takeWhile (/= '#')

strip :: String -> String
strip = dropWhileEnd isSpace . dropWhile isSpace

isName :: String -> Bool
isName (c : cs) = isAlpha c && all (\x -> isAlphaNum x || x == '_') cs
isName [] = False
