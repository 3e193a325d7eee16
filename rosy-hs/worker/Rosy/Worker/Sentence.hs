-- |
-- Module      : Rosy.Worker.Sentence
-- Description : Translatable sentences of the worker: those of the library.
module Rosy.Worker.Sentence
  ( module Rosy.Sentence,
  )
where

import Rosy.Sentence
