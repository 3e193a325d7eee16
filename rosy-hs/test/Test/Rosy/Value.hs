{-# LANGUAGE DeriveGeneric #-}
{-# LANGUAGE ExistentialQuantification #-}
{-# LANGUAGE ScopedTypeVariables #-}
{-# OPTIONS_GHC -Wno-partial-fields #-}

-- |
-- Module      : Test.Rosy.Value
-- Description : Declared types are shown as Haskell shows them, finished in bounds, and begun at their first constructor.
module Test.Rosy.Value (tests) where

import Control.Exception (ErrorCall, evaluate, try)
import Data.Either (isLeft)
import qualified Data.Map as Map
import Rosy.Program
import Rosy.Value (settled, shown)
import Test.QuickCheck
import Test.Tasty (TestTree, testGroup)
import Test.Tasty.HUnit
import Test.Tasty.QuickCheck (testProperty)

-- | All that a declaration can look like.
data Thing a
  = Plain
  | Thing Int a
  | Record {size :: Double, (<+>) :: Maybe a}
  | a :*: [Thing a]
  | Int `Of` a
  deriving (Eq, Show, Generic)

infixr 4 :*:

infixl 6 `Of`

instance Value a => Value (Thing a)

instance Value a => Default (Thing a)

-- | What cannot be shown.
data Opaque = Opaque (Int -> Int) (IO ()) Int
  deriving (Generic)

instance Value Opaque

-- | A parameter of a higher kind, with the context that its declaration gets.
newtype Wrapped f = Wrapped (f Int)
  deriving (Generic)

instance Typeable f => Value (Wrapped f)

-- | No Generic, thus no instance of Value: an existential.
data Some = forall a. Show a => Some a

data H = HA Int | HB
  deriving (Eq, Show, Generic)

instance Value H

instance Default H

instance Arbitrary a => Arbitrary (Thing a) where
  arbitrary = sized go
    where
      go n =
        frequency
          [ (1, pure Plain),
            (1, Thing <$> arbitrary <*> arbitrary),
            (1, Record <$> arbitrary <*> arbitrary),
            (1, Of <$> arbitrary <*> arbitrary),
            (if n > 0 then 2 else 0, (:*:) <$> arbitrary <*> (choose (0, 2) >>= flip vectorOf (go (n `div` 3))))
          ]

tests :: TestTree
tests =
  testGroup
    "Value"
    [ testGroup
        "shows"
        [ testProperty "any declared type as its derived Show does" $ \(x :: Thing Int) -> shown x === show x,
          testProperty "types with parameters as well" $ \(x :: Thing (Thing (Either Bool String))) -> shown x === show x,
          testProperty "the Prelude's types as their Show does" $
            \(x :: (Int, Double, [Maybe Char], String, Either () (Bool, Ordering))) -> shown x === show x,
          testProperty "negative numbers in brackets where Haskell needs them" $ \(n :: Int) -> shown (Just n) === show (Just n),
          testCase "maps as maps" $ shown (Map.fromList [(1 :: Int, "a")]) @?= show (Map.fromList [(1 :: Int, "a")]),
          testCase "what cannot be shown as _" $ shown (Opaque id (pure ()) 3) @?= "Opaque _ _ 3",
          testCase "a type without Generic as _" $ shown [Some 'x'] @?= "[_]",
          testCase "a field of a higher kind as _" $ shown (Wrapped (Just 1)) @?= "Wrapped _"
        ],
      testGroup
        "begins with"
        [ testCase "the first constructor, even if it has fields" $ defaultValue @?= HA 0,
          testCase "False, 0, the empty text, Nothing, the left side" $
            defaultValue @?= (False, 0 :: Int, "", Nothing :: Maybe Int, Left 0 :: Either Double Bool),
          testCase "a function that always gives the beginning of its result" $ (initial :: Bool -> Int) True @?= 0
        ],
      testGroup
        "finishes"
        [ testCase "fields, so that an error in them comes at once" $ do
            result <- try (evaluate (settled (Thing 1 (errorWithoutStackTrace "inside" :: Int))))
            assertBool "throws" (isLeft (result :: Either ErrorCall (Thing Int))),
          testCase "endless lists within its budget" $ take 3 (settled [1 :: Int ..]) @?= [1, 2, 3],
          testCase "endless trees within its budget" $ let tree = () :*: [tree, tree] in settle 1000 tree < 1 @?= True
        ]
    ]
