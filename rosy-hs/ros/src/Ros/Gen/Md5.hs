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
    MissingMessage (..),
    md5,
    fullDefinition,
    md5Text,
  )
where

import Data.Bits (shiftR, (.&.))
import qualified Data.ByteString as B
import qualified Data.ByteString.Unsafe as B
import Data.List (intercalate, nub)
import qualified Data.Map.Strict as Map
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

-- | A message nests another one that was not given.
data MissingMessage = MissingMessage {nestedIn :: MsgName, missing :: MsgName}
  deriving (Eq, Show)

-- | Constants first, then fields; a nested type is replaced by its own sum and loses its array suffix.
md5Text :: Messages -> Msg -> Either MissingMessage String
md5Text known m = intercalate "\n" . (map constant (constants m) ++) <$> traverse field (fields m)
  where
    constant (Constant t n v) = builtinName t ++ " " ++ n ++ "=" ++ v
    field (Field (Builtin t) c n) = Right (builtinName t ++ suffix c ++ " " ++ n)
    field (Field (Nested t) _ n) = (++ (" " ++ n)) <$> (look m t known >>= md5 known)
    suffix One = ""
    suffix Many = "[]"
    suffix (Exactly i) = "[" ++ show i ++ "]"

md5 :: Messages -> Msg -> Either MissingMessage String
md5 known m = digest <$> md5Text known m

-- | The text of the message, then of everything it nests, as @rosbag@ and @rostopic@ expect it.
fullDefinition :: Messages -> Msg -> Either MissingMessage String
fullDefinition known m = do
  below <- nub <$> descend m
  pure (source m ++ concatMap section below)
  where
    descend parent = concat <$> traverse (deeper parent) (nub [t | Field (Nested t) _ _ <- fields parent])
    deeper parent t = do
      child <- look parent t known
      (child :) <$> descend child
    section x = "\n" ++ replicate 80 '=' ++ "\nMSG: " ++ fullName (msgName x) ++ "\n" ++ source x

look :: Msg -> MsgName -> Messages -> Either MissingMessage Msg
look parent t = maybe (Left (MissingMessage (msgName parent) t)) Right . Map.lookup t

digest :: String -> String
digest t = word a ++ word b
  where
    -- The sum of a constant buffer; IO only because base takes a pointer.
    Fingerprint a b = unsafePerformIO (B.unsafeUseAsCStringLen bytes (\(p, n) -> fingerprintData (castPtr p) n))
    bytes = T.encodeUtf8 (T.pack t) :: B.ByteString
    word w = concat [hex ((w `shiftR` s) .&. 0xff) | s <- [56, 48 .. 0]]
    hex x = if x < 16 then '0' : showHex x "" else showHex x ""
