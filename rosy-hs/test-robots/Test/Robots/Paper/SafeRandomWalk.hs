{-# LANGUAGE CPP #-}
{-# LANGUAGE DeriveGeneric #-}
{-# LANGUAGE StandaloneDeriving #-}

-- |
-- Description : The example of this name, from its file, with what its learner may leave out.
module Test.Robots.Paper.SafeRandomWalk (main) where

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

deriving instance Generic (M1 a)

instance Value a => Value (M1 a)

instance Value a => Default (M1 a)

instance Value a => Sensor (M1 a)

instance Value a => Command (M1 a)

deriving instance Generic (M2 a)

instance Value a => Value (M2 a)

instance Value a => Default (M2 a)

instance Value a => Sensor (M2 a)

instance Value a => Command (M2 a)

deriving instance Generic M

instance Value M

instance Default M

instance Sensor M

instance Command M

#include "../../../../../examples/safeRandomWalk/Main.hs"
