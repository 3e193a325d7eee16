-- | The tests of the language. This module only puts them together; each module mirrors the one it tests.
module Main (main) where

import System.Environment (lookupEnv)
import qualified Test.Rosy.Action
import qualified Test.Rosy.Codec
import qualified Test.Rosy.Controller
import qualified Test.Rosy.Documentation
import qualified Test.Rosy.Geometry
import qualified Test.Rosy.LaserScan
import qualified Test.Rosy.Laws
import qualified Test.Rosy.Model
import qualified Test.Rosy.Problem
import qualified Test.Rosy.Provenance
import qualified Test.Rosy.Refused
import qualified Test.Rosy.Task
import qualified Test.Rosy.Value
import qualified Test.Rosy.Wire
import Test.Tasty (defaultMain, testGroup)

main :: IO ()
main = do
  -- Nightly runs draw more random cases (scripts/test.py).
  isNightly <- (== Just "1") <$> lookupEnv "ROSY_TEST_NIGHTLY"
  defaultMain $
    testGroup
      "rosy"
      [ Test.Rosy.Value.tests,
        Test.Rosy.Geometry.tests,
        Test.Rosy.LaserScan.tests,
        Test.Rosy.Controller.tests,
        Test.Rosy.Task.tests,
        Test.Rosy.Action.tests,
        Test.Rosy.Refused.tests,
        Test.Rosy.Laws.tests (if isNightly then 1000000 else 200000),
        Test.Rosy.Model.tests,
        Test.Rosy.Provenance.tests (if isNightly then 100000 else 500),
        Test.Rosy.Problem.tests,
        Test.Rosy.Codec.tests,
        Test.Rosy.Wire.tests,
        Test.Rosy.Documentation.tests
      ]
