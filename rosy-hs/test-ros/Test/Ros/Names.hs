-- |
-- Description : Names and the arguments that change them.
module Test.Ros.Names (tests) where

import Data.List (isInfixOf, isPrefixOf)
import Ros.Names
import Test.Tasty
import Test.Tasty.HUnit
import Test.Tasty.QuickCheck

tests :: TestTree
tests =
  testGroup
    "names"
    [ testGroup
        "as http://wiki.ros.org/Names resolves them"
        [ "/node1" & "bar" --> "/bar",
          "/node1" & "/bar" --> "/bar",
          "/node1" & "~bar" --> "/node1/bar",
          "/wg/node2" & "bar" --> "/wg/bar",
          "/wg/node2" & "/bar" --> "/bar",
          "/wg/node2" & "~bar" --> "/wg/node2/bar",
          "/wg/node3" & "foo/bar" --> "/wg/foo/bar",
          "/wg/node3" & "/foo/bar" --> "/foo/bar",
          "/wg/node3" & "~foo/bar" --> "/wg/node3/foo/bar"
        ],
      testCase "a remapping works on resolved names" $ do
        let naming = start ["bumper:=/mobile_base/events/bumper", "/odom:=pose", "~x:=/y"] (Just "ns") "walker"
        map (resolve naming) ["bumper", "/odom", "~x", "/bumper"] @?= ["/mobile_base/events/bumper", "/ns/pose", "/y", "/bumper"],
      testCase "__name and __ns win over the program and the environment" $
        ownName (start ["__name:=b", "__ns:=/far"] (Just "near") "a") @?= "/far/b",
      testCase "arguments are sorted by what they do" $
        readArguments ["go", "a:=b", "_rate:=5", "__ip:=10.0.0.1", ":=", "x:=", "-v"]
          @?= Arguments [("a", "b"), ("__ip", "10.0.0.1"), ("x", "")] [("rate", "5")] ["go", ":=", "-v"],
      testProperty "a resolved name is absolute and tidy, and stays as it is" $ \n ->
        let naming = start [] Nothing "node"
            r = resolve naming n
         in conjoin [property ("/" `isPrefixOf` r), property (not ("//" `isInfixOf` r)), resolve naming r === r]
    ]
  where
    start args = nodeFullName (readArguments args)
    node & name = (node, name)
    infix 2 &
    infix 1 -->
    (node, name) --> expected =
      testCase (node ++ " " ++ name) $ resolve (start [] (Just (namespaceOf node)) (last (pieces node))) name @?= expected
    namespaceOf node = if node == "/node1" then "" else "wg"
    pieces s = case break (== '/') s of (p, _ : rest) -> p : pieces rest; (p, []) -> [p]
