-- |
-- Module      : Main
-- Description : All tests of the worker.
module Main (main) where

-- The worker links the library that this names.
import Rosy ()
import Test.Tasty (defaultMain, localOption, testGroup)
import Test.Tasty.Runners (NumThreads (..))
import Test.Worker.Client (withWorker)
import qualified Test.Worker.Conversation as Conversation
import qualified Test.Worker.Gallery as Gallery
import qualified Test.Worker.Life as Life
import qualified Test.Worker.Page as Page
import qualified Test.Worker.Places as Places
import qualified Test.Worker.Remember as Remember
import qualified Test.Worker.Wire as Wire

-- | One worker serves one test after the other, as it would serve a class.
main :: IO ()
main = withWorker [] $ \worker -> do
  gallery <- Gallery.tests (pure worker)
  conversations <- Conversation.tests (pure worker)
  defaultMain (localOption (NumThreads 1) (testGroup "worker" [Wire.tests, Remember.tests, Page.tests, conversations, gallery, Places.tests (pure worker), Life.tests (pure worker)]))
