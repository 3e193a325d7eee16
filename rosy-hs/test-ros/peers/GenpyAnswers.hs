-- |
-- Description : What generated message modules make of bytes that come on standard input.
--
-- In: a line for each value, the name of a message and bytes in hexadecimal. Out: for each line the facts that the test compares
-- with genpy's, between tabs.
module GenpyAnswers (Answer, answerTo, answers) where

import qualified Data.ByteString as B
import qualified Data.ByteString.Char8 as C
import Data.List (intercalate)
import qualified Data.Map.Strict as Map
import Data.Proxy (Proxy (..))
import Numeric (readHex, showHex)
import Ros.Message
import System.IO (hSetEncoding, stdin, stdout, utf8)

type Answer = B.ByteString -> String

-- | For a message type and its constants.
answerTo :: forall a. (Message a, Show a) => Proxy a -> [String] -> Answer
answerTo p constants bytes =
  intercalate "\t" $
    [messageType p, messageMd5 p, hex (encode zero), show zero, if null constants then "-" else unwords constants, hex (C.pack (utf8Bytes (messageDefinition p)))]
      ++ either (\e -> [show e]) (\value -> [hex (encode (value :: a)), show value]) (decode bytes)
  where
    zero = def :: a
    utf8Bytes = C.unpack . B.drop 4 . encode

answers :: [(String, Answer)] -> IO ()
answers known = do
  mapM_ (`hSetEncoding` utf8) [stdin, stdout]
  getContents >>= mapM_ (putStrLn . one . words) . lines
  where
    byName = Map.fromList known
    one [name, bytes] = maybe (name ++ "\tunknown") ($ unhex bytes) (Map.lookup name byName)
    one line = unwords ("not understood:" : line)

hex :: B.ByteString -> String
hex bytes = if B.null bytes then "-" else concatMap (\b -> if b < 16 then '0' : showHex b "" else showHex b "") (B.unpack bytes)

unhex :: String -> B.ByteString
unhex = B.pack . go
  where
    go (a : b : rest) = fst (head (readHex [a, b])) : go rest
    go _ = []
