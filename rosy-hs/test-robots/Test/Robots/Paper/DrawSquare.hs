{-# LANGUAGE CPP #-}

-- |
-- Description : The example of this name, from its file, with what its learner may leave out.
module Test.Robots.Paper.DrawSquare (main) where

import Rosy hiding (drive, turn)

#include "../../../../../examples/drawSquare/Main.hs"
