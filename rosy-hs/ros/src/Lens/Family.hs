-- |
-- Module      : Lens.Family
-- Description : "Ros.Lens" under the name by which roshask's programs import the functions for fields.
--
-- The package lens-family-core has more of them; a program that uses both says @mixins: rosy:ros hiding (Lens.Family)@.
module Lens.Family
  ( module Ros.Lens,
  )
where

import Ros.Lens
