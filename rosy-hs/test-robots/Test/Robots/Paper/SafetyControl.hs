{-# LANGUAGE CPP #-}

-- |
-- Description : The example of this name, from its file, with what its learner may leave out.
module Test.Robots.Paper.SafetyControl (main) where

import Rosy

#include "../../../../../examples/safetyControl/Main.hs"
