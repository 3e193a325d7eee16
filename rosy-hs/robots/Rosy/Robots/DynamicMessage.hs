{-# LANGUAGE DataKinds #-}
{-# LANGUAGE KindSignatures #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Robots.DynamicMessage
-- Description : ROS 1 messages whose layout is data: bytes to JSON and back.
--
-- In: the texts of message definitions ("Rosy.Robot.Known", "Rosy.Robots.StandardMessages", and the user's own). Out: an instance of 'Ros.Message.Message' for each of them, under the
-- message's name as a type-level symbol. So the links share one codec ("Rosy.Codec"), and a new channel needs no code here.
-- Fields that a JSON message lacks are sent as zeros.
module Rosy.Robots.DynamicMessage
  ( DynamicMessage (..),
    hasDefinition,
  )
where

import Control.Exception (IOException, try)
import Control.Monad (replicateM)
import Data.Aeson (Value (..))
import qualified Data.Aeson.Key as Key
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Binary.Get (Get)
import qualified Data.ByteString as B
import Data.ByteString.Builder (Builder)
import Data.Either (fromRight)
import Data.Int (Int16, Int32, Int64, Int8)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, isJust)
import Data.Proxy (Proxy (..))
import Data.Scientific (toBoundedInteger)
import qualified Data.Text as T
import qualified Data.Vector as V
import Data.Word (Word16, Word32, Word64, Word8)
import GHC.Float (double2Float, float2Double)
import GHC.TypeLits (KnownSymbol, Symbol, symbolVal)
import Ros.Gen.Md5
import Ros.Gen.Msg
import Ros.Message (Default (..), Message (..), ROSDuration, ROSTime, RosBinary (..))
import Rosy.JsonNumber (doubleIn, doubleValue)
import Rosy.Profile (robotMessages)
import Rosy.Robot.Known (robots)
import Rosy.Robots.StandardMessages (standardMessages)
import Rosy.Robots.TextFile (decodeText)
import System.Directory (listDirectory)
import System.Environment (lookupEnv)
import System.FilePath (splitSearchPath, takeBaseName, takeExtension, (</>))
import System.IO.Unsafe (unsafePerformIO)

-- | A message of the type @package/Name@, as JSON.
newtype DynamicMessage (name :: Symbol) = DynamicMessage Value

instance KnownSymbol name => Message (DynamicMessage name) where
  messageType _ = symbolVal (Proxy :: Proxy name)
  messageMd5 _ = described (md5 definitions) (symbolVal (Proxy :: Proxy name))
  messageDefinition _ = described (fullDefinition definitions) (symbolVal (Proxy :: Proxy name))

instance Default (DynamicMessage name) where def = DynamicMessage Null

instance KnownSymbol name => RosBinary (DynamicMessage name) where
  put (DynamicMessage v) = maybe mempty (`putMsg` v) (definition (symbolVal (Proxy :: Proxy name)))
  get = DynamicMessage <$> maybe (fail "an unknown message") getMsg (definition (symbolVal (Proxy :: Proxy name)))

described :: (Msg -> Either e String) -> String -> String
described make = maybe "" (fromRight "" . make) . definition

-- | Whether there is a layout for a message type.
hasDefinition :: String -> Bool
hasDefinition = isJust . definition

definitions :: Messages
definitions = withoutCycles . messages $ [m | (package', name, text) <- standardMessages ++ concatMap robotMessages robots ++ ownMessages, Right m <- [readMsg (MsgName package' name) text]]

-- | The message definitions of the person at this computer: @package/Name.msg@ or @package/msg/Name.msg@ in each folder of @ROSY_MSG_PATH@, which
-- is separated by colons. Read once; a folder or file that cannot be read is left out, and its messages are then not described.
ownMessages :: [(String, String, String)]
ownMessages = unsafePerformIO $ do
  found <- fromMaybe "" <$> lookupEnv "ROSY_MSG_PATH"
  concat <$> mapM inFolder (filter (not . null) (splitSearchPath found))
  where
    inFolder folder = namesIn folder >>= fmap concat . mapM (\package' -> (++) <$> ofPackage package' (folder </> package') <*> ofPackage package' (folder </> package' </> "msg"))
    ofPackage package' folder = do
      names <- namesIn folder
      concat <$> sequence [maybe [] (\text -> [(package', takeBaseName name, text)]) <$> contentOf (folder </> name) | name <- names, takeExtension name == ".msg"]
    namesIn :: FilePath -> IO [FilePath]
    namesIn folder = either (const [] :: IOException -> [FilePath]) id <$> try (listDirectory folder)
    contentOf :: FilePath -> IO (Maybe String)
    contentOf file = either (const Nothing :: IOException -> Maybe String) (fmap T.unpack . decodeText) <$> try (B.readFile file)
{-# NOINLINE ownMessages #-}

-- | A package with another name may have the same messages.
definition :: String -> Maybe Msg
definition name = case readMsgName name of
  Right n | Just m <- Map.lookup n definitions -> Just m
  Right n -> case [m | m <- Map.elems definitions, base (msgName m) == base n] of
    m : _ -> Just m {msgName = n}
    [] -> Nothing
  Left _ -> Nothing

getMsg :: Msg -> Get Value
getMsg m = Object . KeyMap.fromList <$> mapM (\f -> (,) (Key.fromString (fieldName f)) <$> getField f) (fields m)

getField :: Field -> Get Value
getField (Field t count _) = case count of
  One -> one
  Many -> (get :: Get Word32) >>= several . fromIntegral
  Exactly n -> several n
  where
    several n
      | n > largest = fail "an impossible length"
      | otherwise = Array . V.fromList <$> replicateM n one
    one = case t of
      Builtin b -> getBuiltin b
      Nested name -> maybe (fail "an unknown message") getMsg (Map.lookup name definitions)

-- | The most elements of an array that are believed; the longest in use has 36.
largest :: Int
largest = 65536

getBuiltin :: Builtin -> Get Value
getBuiltin b = case b of
  TBool -> Bool <$> get
  TInt8 -> whole (get :: Get Int8)
  TUInt8 -> whole (get :: Get Word8)
  TInt16 -> whole (get :: Get Int16)
  TUInt16 -> whole (get :: Get Word16)
  TInt32 -> whole (get :: Get Int32)
  TUInt32 -> whole (get :: Get Word32)
  TInt64 -> whole (get :: Get Int64)
  TUInt64 -> whole (get :: Get Word64)
  TFloat32 -> doubleValue . float2Double <$> get
  TFloat64 -> doubleValue <$> get
  TString -> String . T.pack <$> get
  TTime -> (\(s, n) -> moment (fromIntegral s) (fromIntegral n)) <$> (get :: Get ROSTime)
  TDuration -> (\(s, n) -> moment (fromIntegral s) (fromIntegral n)) <$> (get :: Get ROSDuration)
  TByte -> whole (get :: Get Int8)
  TChar -> whole (get :: Get Word8)
  where
    whole :: Integral n => Get n -> Get Value
    whole = fmap (Number . fromIntegral)
    moment s n = Object (KeyMap.fromList [("secs", Number s), ("nsecs", Number n)])

putMsg :: Msg -> Value -> Builder
putMsg m v = foldMap (\f -> putField f (inside (fieldName f) v)) (fields m)
  where
    inside name (Object o) = fromMaybe Null (KeyMap.lookup (Key.fromString name) o)
    inside _ _ = Null

putField :: Field -> Value -> Builder
putField (Field t count _) v = case count of
  One -> one v
  Many -> put (fromIntegral (length items) :: Word32) <> foldMap one items
  Exactly n -> foldMap one (take n (items ++ repeat Null))
  where
    items = case v of
      Array a -> V.toList a
      _ -> []
    one = case t of
      Builtin b -> putBuiltin b
      Nested name -> maybe mempty putMsg (Map.lookup name definitions)

putBuiltin :: Builtin -> Value -> Builder
putBuiltin b v = case b of
  TBool -> put (v == Bool True)
  TInt8 -> put (whole :: Int8)
  TUInt8 -> put (whole :: Word8)
  TInt16 -> put (whole :: Int16)
  TUInt16 -> put (whole :: Word16)
  TInt32 -> put (whole :: Int32)
  TUInt32 -> put (whole :: Word32)
  TInt64 -> put (whole :: Int64)
  TUInt64 -> put (whole :: Word64)
  TFloat32 -> put (double2Float decimal)
  TFloat64 -> put decimal
  TString -> put (case v of String s -> T.unpack s; _ -> "")
  TTime -> put (def :: ROSTime)
  TDuration -> put (def :: ROSDuration)
  TByte -> put (whole :: Int8)
  TChar -> put (whole :: Word8)
  where
    whole :: (Bounded n, Integral n) => n
    whole = case v of
      Number n -> fromMaybe 0 (toBoundedInteger n)
      _ -> 0
    decimal = fromMaybe 0 (doubleIn v)
