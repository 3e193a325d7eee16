-- |
-- Module      : Ros.Header
-- Description : Messages that say when and where.
--
-- A message whose definition has a @Header header@ is stamped: it carries a time and the name of a
-- coordinate frame. The instances are generated.
module Ros.Header
  ( HasHeader (..),
    stampOf,
    frameOf,
    numbered,
  )
where

import Ros.Lens (Lens, (^.))
import Ros.Message (ROSTime, numbered)
import Ros.Std_msgs.Header (Header, frame_id, stamp)

class HasHeader a where
  headerOf :: Lens a Header

stampOf :: HasHeader a => a -> ROSTime
stampOf x = x ^. headerOf . stamp

frameOf :: HasHeader a => a -> String
frameOf x = x ^. headerOf . frame_id
