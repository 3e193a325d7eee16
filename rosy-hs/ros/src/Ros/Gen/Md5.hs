-- |
-- Module      : Ros.Gen.Md5
-- Description : The MD5 sum by which two nodes know that they mean the same message.
--
-- In: a message and all messages that it nests. Out: the sum, and the full definition text that
-- travels in a connection header. The rules are genmsg's (@gentools.py@: @compute_md5_text@,
-- @compute_full_text@). No messages are read from disk here.
module Ros.Gen.Md5
  ( Messages,
    messages,
    NestingError (..),
    explainNestingError,
    withoutCycles,
    md5,
    serviceMd5,
    fullDefinition,
    md5Text,
  )
where

import Control.Monad (foldM)
import Data.Bits (shiftR, (.&.))
import qualified Data.ByteString as B
import qualified Data.ByteString.Unsafe as B
import Data.List (intercalate, nub)
import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import qualified Data.Text as T
import qualified Data.Text.Encoding as T
import Foreign.Ptr (castPtr)
import GHC.Fingerprint (Fingerprint (..), fingerprintData)
import Numeric (showHex)
import Ros.Gen.Msg
import System.IO.Unsafe (unsafePerformIO)

type Messages = Map.Map MsgName Msg

messages :: [Msg] -> Messages
messages ms = Map.fromList [(msgName m, m) | m <- ms]

data NestingError
  = -- | A message nests another one that was not given: which, and the other.
    MissingMessage MsgName MsgName
  | -- | Each message nests the next one, and the last is the first: such a message would have no end.
    CyclicMessage [MsgName]
  deriving (Eq, Show)

explainNestingError :: NestingError -> String
explainNestingError e = case e of
  MissingMessage parent child -> fullName parent ++ " nests " ++ fullName child ++ ", which was not found; add its folder with -I"
  CyclicMessage names -> intercalate " nests " (map fullName names) ++ ", so a message of this type would have no end"

-- | A cycle among what a message nests, if there is one. What was not given is left out.
acyclic :: Messages -> Msg -> Either NestingError ()
acyclic known = (() <$) . visit [] Set.empty . msgName
  where
    -- The messages above this one, the next one first, and those that are known to be without a cycle.
    visit above fine name
      | name `elem` above = Left (CyclicMessage (name : reverse (takeWhile (/= name) above) ++ [name]))
      | name `Set.member` fine = Right fine
      | otherwise = Set.insert name <$> foldM (visit (name : above)) fine [t | Just m <- [Map.lookup name known], Field (Nested t) _ _ <- fields m]

-- | The messages that have an end.
withoutCycles :: Messages -> Messages
withoutCycles known = Map.filter (either (const False) (const True) . acyclic known) known

-- | Constants first, then fields; a nested type is replaced by its own sum and loses its array suffix.
md5Text :: Messages -> Msg -> Either NestingError String
md5Text known m = acyclic known m >> md5TextOf known m

-- | For messages without cycles.
md5TextOf :: Messages -> Msg -> Either NestingError String
md5TextOf known m = intercalate "\n" . (map constant (constants m) ++) <$> traverse field (fields m)
  where
    constant (Constant t n v) = builtinName t ++ " " ++ n ++ "=" ++ v
    field (Field (Builtin t) c n) = Right (builtinName t ++ suffix c ++ " " ++ n)
    field (Field (Nested t) _ n) = (++ (" " ++ n)) . digest <$> (look m t known >>= md5TextOf known)
    suffix One = ""
    suffix Many = "[]"
    suffix (Exactly i) = "[" ++ show i ++ "]"

md5 :: Messages -> Msg -> Either NestingError String
md5 known m = digest <$> md5Text known m

-- | Of a service: of the texts of its request and its response, one behind the other.
serviceMd5 :: Messages -> Msg -> Msg -> Either NestingError String
serviceMd5 known request response = digest <$> ((++) <$> md5Text known request <*> md5Text known response)

-- | The text of the message, then of everything it nests, as @rosbag@ and @rostopic@ expect it.
fullDefinition :: Messages -> Msg -> Either NestingError String
fullDefinition known m = do
  acyclic known m
  below <- nub <$> descend m
  pure (source m ++ concatMap section below)
  where
    descend parent = concat <$> traverse (deeper parent) (nub [t | Field (Nested t) _ _ <- fields parent])
    deeper parent t = do
      child <- look parent t known
      (child :) <$> descend child
    section x = "\n" ++ replicate 80 '=' ++ "\nMSG: " ++ fullName (msgName x) ++ "\n" ++ source x

look :: Msg -> MsgName -> Messages -> Either NestingError Msg
look parent t = maybe (Left (MissingMessage (msgName parent) t)) Right . Map.lookup t

digest :: String -> String
digest t = word a ++ word b
  where
    -- The sum of a constant buffer; IO only because base takes a pointer.
    Fingerprint a b = unsafePerformIO (B.unsafeUseAsCStringLen bytes (\(p, n) -> fingerprintData (castPtr p) n))
    bytes = T.encodeUtf8 (T.pack t) :: B.ByteString
    word w = concat [hex ((w `shiftR` s) .&. 0xff) | s <- [56, 48 .. 0]]
    hex x = if x < 16 then '0' : showHex x "" else showHex x ""
