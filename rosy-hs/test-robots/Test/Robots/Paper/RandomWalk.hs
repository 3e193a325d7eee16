{-# LANGUAGE CPP #-}
{-# LANGUAGE DeriveGeneric #-}
{-# LANGUAGE StandaloneDeriving #-}

-- |
-- Description : The example of this name, from its file, with what its learner may leave out.
module Test.Robots.Paper.RandomWalk (main) where

import GHC.Generics (Generic)
import Rosy
import Rosy.Program

deriving instance Generic Mode

instance Value Mode

instance Default Mode

instance Sensor Mode

instance Command Mode

deriving instance Generic ChgDir

instance Value ChgDir

instance Default ChgDir

instance Sensor ChgDir

instance Command ChgDir

#include "../../../../../examples/randomWalk/Main.hs"
