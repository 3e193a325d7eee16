{-# LANGUAGE CPP #-}

-- |
-- Description : The program of this name of the table of motions, from its file.
module Test.Robots.Motion.Timed (main) where

import Rosy

#include "../../../motion/Timed.hs"
