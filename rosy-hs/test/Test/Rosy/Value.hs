{-# LANGUAGE DeriveGeneric #-}
{-# LANGUAGE ExistentialQuantification #-}
{-# LANGUAGE ScopedTypeVariables #-}
{-# OPTIONS_GHC -Wno-partial-fields #-}

-- |
-- Module      : Test.Rosy.Value
-- Description : Declared types are shown as Haskell shows them, finished in bounds, and begun at their first constructor.
module Test.Rosy.Value (tests) where

import Control.Exception (ErrorCall, evaluate, try)
import Control.Monad (void)
import Data.Either (isLeft)
import qualified Data.Map as Map
import Data.Maybe (fromMaybe, isJust)
import GHC.Float (castDoubleToWord64, castWord64ToDouble)
import GHC.Generics (Generic)
import Rosy.Model (Built (..), Declarations, defaultOf)
import Rosy.Problem (Fault (NoDefault))
import Rosy.Program
import Rosy.Value (nonePending, settled, shown)
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

-- | Of all sizes, many where a number is written without an exponent, at powers of two and of ten, and with few digits.
fractions :: Gen Double
fractions = do
  x <-
    oneof
      [ castWord64ToDouble <$> arbitrary,
        (10 **) <$> choose (-3, 9),
        (\n k -> fromIntegral (n :: Int) / 10 ^ (k :: Int)) <$> choose (0, 100000000) <*> choose (0, 12),
        near ((2 **) . fromIntegral <$> choose (-8, 30 :: Int)),
        near ((10 **) . fromIntegral <$> choose (-3, 9 :: Int)),
        arbitrary
      ]
  elements [x, negate x]
  where
    -- A few representable numbers away.
    near xs = (\x n -> castWord64ToDouble (castDoubleToWord64 x + fromIntegral (n :: Int))) <$> xs <*> choose (-3, 3)

-- | One whose instance is what "Rosy.Program" adds to a program.
data Declared a
  = Silent
  | Spoken Int a
  | Named {volume :: Double, (<->) :: Maybe a}
  | Choir [Declared a]
  | a :~ Declared a
  deriving (Eq, Show)

infixr 3 :~

instance Value a => Value (Declared a) where
  parts x = case x of
    Silent -> Parts "Silent" [] []
    Spoken a b -> Parts "Spoken" [] [Field a, Field b]
    Named a b -> Parts "Named" ["volume", "<->"] [Field a, Field b]
    Choir a -> Parts "Choir" [] [Field a]
    a :~ b -> InfixParts 3 ":~" (Field a) (Field b)
  display = displayParts
  settle = settleParts
  initial = initialFrom [construct Silent, withField (withField (construct Spoken)), withField (withField (construct Named)), withField (construct Choir), withField (withField (construct (:~)))]

instance Value a => Default (Declared a)

instance Arbitrary a => Arbitrary (Declared a) where
  arbitrary = sized $ \n ->
    oneof ([pure Silent, Spoken <$> arbitrary <*> arbitrary, Named <$> arbitrary <*> arbitrary] ++ [Choir <$> (choose (0, 3) >>= flip vectorOf (resize (n `div` 3) arbitrary)) | n > 0] ++ [(:~) <$> arbitrary <*> resize (n `div` 2) arbitrary | n > 0])

-- | No finite value, written in the same way.
newtype Endless = Endless Endless

instance Value Endless where
  parts (Endless x) = Parts "Endless" [] [Field x]
  display = displayParts
  settle = settleParts
  initial = initialFrom [withField (construct Endless)]

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

-- | The first constructor needs the type itself.
data Stack = Push Int Stack | Empty
  deriving (Eq, Show, Generic)

instance Value Stack

instance Default Stack

-- | Two types that need each other.
data Even = Odd1 Odd | Zero
  deriving (Eq, Show, Generic)

data Odd = Even1 Even | One
  deriving (Eq, Show, Generic)

instance Value Even

instance Default Even

instance Value Odd

instance Default Odd

-- | No finite value at all.
data Loop = Loop Int Loop | Again Loop
  deriving (Show, Generic)

instance Value Loop

instance Default Loop

-- | Finite only through containers, which start empty.
data Tree = Node Int [Tree] (Maybe Tree)
  deriving (Eq, Show, Generic)

instance Value Tree

instance Default Tree

-- | Each level needs a larger application of the type.
data Nest a = Deep (Nest [a]) | Flat a
  deriving (Eq, Show, Generic)

instance Value a => Value (Nest a)

instance Value a => Default (Nest a)

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

-- | The declarations of the types above, for the model.
declared :: Declarations
declared =
  constructorsIn
    [ ("HA", [("HA", ["Int"]), ("HB", [])]),
      ("Stack", [("Push", ["Int", "Stack"]), ("Empty", [])]),
      ("Even", [("Odd1", ["Odd"]), ("Zero", [])]),
      ("Odd", [("Even1", ["Even"]), ("One", [])]),
      ("Tree", [("Node", ["Int", "List", "Maybe"])]),
      ("Int", [("0", [])]),
      ("List", [("[]", [])]),
      ("Maybe", [("Nothing", []), ("Just", ["Tree"])])
    ]

constructorsIn :: [(String, [(String, [String])])] -> Declarations
constructorsIn types name = fromMaybe [] (lookup name types)

-- | The default of a Haskell type, of the model, and the expected one.
begins :: Show a => String -> a -> Built -> TestTree
begins name value wanted = testCase name $ do
  defaultOf declared name @?= Just wanted
  show value @?= written 0 wanted
  where
    written :: Int -> Built -> String
    written _ (Built c []) = c
    written d (Built c fields) = (if d > 10 then \s -> "(" ++ s ++ ")" else id) (unwords (c : map (written 11) fields))

-- | Up to five types that refer to each other.
declarations :: Gen [(String, [(String, [String])])]
declarations = do
  n <- choose (1, 5)
  let names = take n ["A", "B", "C", "D", "E"]
  mapM (\name -> (,) name <$> resize 3 (listOf ((,) <$> elements ["X", "Y", "Z"] <*> resize 3 (listOf (elements names))))) names

-- | The types that have a finite value: the least fixed point.
inhabited :: [(String, [(String, [String])])] -> [String]
inhabited types = go []
  where
    go known
      | next == known = known
      | otherwise = go next
      where
        next = [name | (name, constructors) <- types, any (all (`elem` known) . snd) constructors]

tests :: TestTree
tests =
  testGroup
    "Value"
    [ testGroup
        "shows"
        [ testProperty "any declared type as its derived Show does" $ \(x :: Thing Int) -> shown x === show x,
          testProperty "types with parameters as well" $ \(x :: Thing (Thing (Either Bool String))) -> shown x === show x,
          testProperty "a type whose constructors are written down as well" $ \(x :: Declared (Declared (Either Int String))) -> shown x === show x,
          testProperty "the Prelude's types as their Show does" $
            \(x :: (Int, Double, [Maybe Char], String, Either () (Bool, Ordering))) -> shown x === show x,
          testProperty "negative numbers in brackets where Haskell needs them" $ \(n :: Int) -> shown (Just n) === show (Just n),
          testProperty "fractions with the same digits" . withMaxSuccess 2000 $ forAll fractions $ \x -> shown (Just x) === show (Just x),
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
          testCase "a function that always gives the beginning of its result" $ fmap ($ True) (initial nonePending :: Maybe (Bool -> Int)) @?= Just 0,
          testGroup
            "what the model says"
            [ begins "HA" (defaultValue :: H) (Built "HA" [Built "0" []]),
              begins "Stack" (defaultValue :: Stack) (Built "Empty" []),
              begins "Even" (defaultValue :: Even) (Built "Odd1" [Built "One" []]),
              begins "Odd" (defaultValue :: Odd) (Built "Even1" [Built "Zero" []]),
              begins "Tree" (defaultValue :: Tree) (Built "Node" [Built "0" [], Built "[]" [], Built "Nothing" []])
            ],
          testCase "the first constructor that is written down" $ (defaultValue, defaultValue) @?= (Silent :: Declared Int, Left Silent :: Either (Declared Int) Int),
          testCase "nothing, where the constructors that are written down need each other" $ void (initial nonePending :: Maybe Endless) @?= Nothing,
          testCase "a smaller application of its own type" $ (defaultValue :: Either (Either Int Bool) Int) @?= Left (Left 0),
          testCase "never a larger application of its own type" $ (defaultValue :: Nest Int) @?= Flat 0,
          testCase "nothing, where every value is infinite" $ do
            result <- try (evaluate (defaultValue :: Loop))
            either Just (const Nothing) result @?= Just (NoDefault "Loop"),
          testProperty "in the model, exactly when the type has a finite value" $
            forAllShow declarations show $ \types ->
              conjoin [isJust (defaultOf (constructorsIn types) name) === (name `elem` inhabited types) | (name, _) <- types]
        ],
      testGroup
        "finishes"
        [ testCase "fields, so that an error in them comes at once" $ do
            result <- try (evaluate (settled (Thing 1 (errorWithoutStackTrace "inside" :: Int))))
            assertBool "throws" (isLeft (result :: Either ErrorCall (Thing Int)))
            written <- try (evaluate (settled (Choir [Silent, Spoken 1 (errorWithoutStackTrace "inside" :: Int)])))
            assertBool "throws" (isLeft (written :: Either ErrorCall (Declared Int))),
          testCase "endless lists within its budget" $ take 3 (settled [1 :: Int ..]) @?= [1, 2, 3],
          testCase "endless trees within its budget" $ let tree = () :*: [tree, tree] in settle 1000 tree < 1 @?= True,
          testCase "endless trees that are written down as well" $ let tree = Choir [tree, tree] :: Declared () in settle 1000 tree < 1 @?= True
        ]
    ]
