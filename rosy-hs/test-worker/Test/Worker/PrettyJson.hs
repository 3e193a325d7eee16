{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Test.Worker.PrettyJson
-- Description : JSON in the layout of the golden files: keys in order, small values on one line.
module Test.Worker.PrettyJson (pretty) where

import Data.Aeson (Value (..), encode)
import qualified Data.Aeson.Key as Key
import qualified Data.Aeson.KeyMap as KeyMap
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (toList)
import Data.List (intersperse, sortOn)

-- | A value with its lists and objects spread over lines, small ones excepted.
pretty :: Value -> Lazy.ByteString
pretty v = go "" v <> "\n"
  where
    go indent value = case value of
      Array xs | not (null xs) -> spread indent "[" "]" (map (go (indent <> "  ")) (toList xs))
      Object o
        | Lazy.length (compact value) > 60 ->
          spread indent "{" "}" [encode (Key.toText k) <> ": " <> go (indent <> "  ") x | (k, x) <- sortOn (Key.toText . fst) (KeyMap.toList o)]
      _ -> compact value
    spread indent open close parts = open <> "\n" <> Lazy.concat (intersperse ",\n" (map ((indent <> "  ") <>) parts)) <> "\n" <> indent <> close
    compact value = case value of
      Object o -> "{" <> Lazy.concat (intersperse ", " [encode (Key.toText k) <> ": " <> compact x | (k, x) <- sortOn (Key.toText . fst) (KeyMap.toList o)]) <> "}"
      _ -> encode value
