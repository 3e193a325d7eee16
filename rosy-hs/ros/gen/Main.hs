-- |
-- Description : rosy-messages: .msg and .srv files in, Haskell modules out.
--
-- > rosy-messages -o OUT [-I MSGS]... [-L MSGS]... PACKAGE[/NAME]...
--
-- Every folder given with @-I@ holds packages (@std_msgs/String.msg@ or, as ROS installs them,
-- @std_msgs/msg/String.msg@). All messages and services of the named packages, single ones that are named, and all that they
-- nest, become modules below OUT; their names are printed, ready for a cabal file. Messages in the folders given with @-L@ are in a
-- library already, all or those that @compiled.txt@ there lists, so they are not made again. A module whose text has not changed is not touched.
module Main (main) where

import Ros.Gen.Files (generate)
import System.Environment (getArgs)

main :: IO ()
main = getArgs >>= generate
