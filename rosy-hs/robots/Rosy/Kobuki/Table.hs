-- |
-- Module      : Rosy.Kobuki.Table
-- Description : The serial encoding of the channels of the base, from its description.
module Rosy.Kobuki.Table
  ( serialTable,
  )
where

import Rosy.Channel (Channel)
import Rosy.Profile (Robot (..), Serial)
import Rosy.Robot.Known (robots)

-- | By channel, in the order in which one packet reports changes.
serialTable :: [(Channel, Serial)]
serialTable = concatMap robotSerial (take 1 (filter (not . null . robotSerial) robots))
