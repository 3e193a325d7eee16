-- |
-- Description : rosy-messages: .msg files in, Haskell modules out.
--
-- > rosy-messages -o OUT [-I MSGS]... PACKAGE...
--
-- Every folder given with @-I@ holds packages (@kobuki_msgs/Led.msg@ or, as ROS installs them,
-- @kobuki_msgs/msg/Led.msg@). All messages of the named packages become modules below OUT; their
-- names are printed, ready for a cabal file. A module whose text has not changed is not touched.
module Main (main) where

import Ros.Gen.Files (generate)
import System.Environment (getArgs)

main :: IO ()
main = getArgs >>= generate
