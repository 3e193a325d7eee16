-- |
-- Module      : Data.Default.Generics
-- Description : What a message is before anyone fills it, under the name by which roshask's programs import it.
module Data.Default.Generics
  ( Default (..),
  )
where

import Ros.Message (Default (..))
