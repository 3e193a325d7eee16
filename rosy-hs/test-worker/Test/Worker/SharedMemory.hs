{-# LANGUAGE ForeignFunctionInterface #-}

-- |
-- Module      : Test.Worker.SharedMemory
-- Description : Properties of the decoder of the shared page: any content yields harmless text. Which pages of free memory are given back.
module Test.Worker.SharedMemory (tests) where

import qualified Data.ByteString as ByteString
import Data.Char (isPrint)
import qualified Data.Text as Text
import Data.Text.Encoding (encodeUtf8)
import Data.Word (Word8)
import Foreign.C.Types (CInt (..))
import Foreign.Marshal.Utils (with)
import Foreign.Ptr (Ptr, WordPtr (..))
import Foreign.Storable (peek)
import Rosy.Worker.SharedMemory
import Test.Tasty (TestTree, testGroup)
import Test.Tasty.HUnit (testCase, (@?=))
import Test.Tasty.QuickCheck

-- | A page with some bytes behind a place and a length.
paged :: Int -> Int -> [Word8] -> ByteString.ByteString
paged place size bytes = ByteString.take pageSize (ByteString.concat [word place, pad, word size, ByteString.pack bytes, ByteString.replicate pageSize 0])
  where
    -- What lies behind the page is none of it: a place may be four thousand million bytes away.
    pad = ByteString.replicate (max 0 (min pageSize place - 4)) 0

word :: Int -> ByteString.ByteString
word n = ByteString.pack [fromIntegral (n `div` 256 ^ i) | i <- [0 .. 3 :: Int]]

-- | Places and lengths at the edges, and any.
number :: Gen Int
number = oneof [elements [0, 1, 3, 4, 5, 4091, 4092, 4093, 4096, 0x7fffffff, 0x80000000, 0xffffffff], choose (0, 5000), choose (0, 0xffffffff)]

-- | @rosy_pages.h@: where the whole pages of a range begin and end; 'Nothing' when there is none.
wholePages :: Word -> (Word, Word) -> IO (Maybe (Word, Word))
wholePages page (begin, end) =
  with (WordPtr begin) $ \first -> with (WordPtr end) $ \behind -> do
    found <- c_wholePages first behind (WordPtr page)
    WordPtr from <- peek first
    WordPtr to <- peek behind
    pure (if found == 0 then Nothing else Just (from, to))

foreign import ccall unsafe "rosy_whole_pages" c_wholePages :: Ptr WordPtr -> Ptr WordPtr -> WordPtr -> IO CInt

tests :: TestTree
tests = testGroup "shared and free memory" [pageOfAProgram, freePages]

freePages :: TestTree
freePages =
  testGroup
    "free blocks of 4 kB"
    [ testCase "are given back where pages are as large" $
        wholePages 0x1000 (0x5000, 0x7000) >>= (@?= Just (0x5000, 0x7000)),
      testCase "are given back in pages of 16 kB that hold no other block" $
        wholePages 0x4000 (0x5000, 0xf000) >>= (@?= Just (0x8000, 0xc000)),
      testCase "stay where they fill no page" $
        wholePages 0x4000 (0x4000, 0x7000) >>= (@?= Nothing)
    ]

pageOfAProgram :: TestTree
pageOfAProgram =
  testGroup
    "the page of a program"
    [ testProperty "a name is read back" $ \(PrintableString name) ->
        let text = Text.pack (take 200 (filter isPrint name))
            bytes = ByteString.unpack (encodeUtf8 text)
         in activeFunctionName (paged 8 (length bytes) bytes) === text,
      testProperty "whatever stands there, little is shown, and nothing that is not printed" $
        forAll ((,,) <$> number <*> number <*> listOf arbitrary) $ \(place, size, bytes) ->
          let shown = activeFunctionName (paged place size bytes)
           in Text.all isPrint shown .&&. counterexample (show shown) (Text.length shown <= 1024),
      testCase "no line ends, no escapes, and no letters that turn the text around" $
        activeFunctionName (paged 4 40 (ByteString.unpack (encodeUtf8 (Text.pack "a\n{\"op\":\"said\"}\ESC[2J\x202e\x2028\x85z")))) @?= Text.pack "a{\"op\":\"said\"}[2Jz"
    ]
