{-# LANGUAGE OverloadedStrings #-}
-- |
-- Module      : Rosy.Worker.Kind
-- Description : What the compiler said, in words for learners.
module Rosy.Worker.Kind (explainAll) where

import qualified Data.Text as Text
import Rosy.Worker.Problem
import Rosy.Worker.Raw

explainAll :: Outline -> [Raw] -> [Problem]
explainAll _ = map one
  where
    one r = Problem (gravity r) (Text.pack (show (reason r))) (region r) Nothing (Text.unlines (important r)) "" (Text.unlines (important r ++ context r ++ supplementary r))
