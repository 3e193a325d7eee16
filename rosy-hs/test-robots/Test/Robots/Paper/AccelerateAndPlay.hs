{-# LANGUAGE CPP #-}

-- |
-- Description : The example of this name, from its file, with what its learner may leave out.
module Test.Robots.Paper.AccelerateAndPlay (main) where

import Rosy

#include "../../../../../examples/accelerateAndPlay/Main.hs"
