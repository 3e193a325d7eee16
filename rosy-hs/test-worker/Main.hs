-- |
-- Module      : Main
-- Description : All tests of the worker.
module Main (main) where

-- The worker links the library that this names.
import Rosy ()
import Test.Tasty (defaultMain, localOption, testGroup)
import Test.Tasty.Runners (NumThreads (..))
import Test.Worker.Client (withWorker)
import qualified Test.Worker.DeclaredTypes as DeclaredTypes
import qualified Test.Worker.Gallery as Gallery
import qualified Test.Worker.GoldenConversations as Conversation
import qualified Test.Worker.LruCache as Remember
import qualified Test.Worker.PreparedRuns as Prepared
import qualified Test.Worker.ProcessLifecycle as Life
import qualified Test.Worker.ProgramGraphs as Graphs
import qualified Test.Worker.PureParts as Wire
import qualified Test.Worker.SharedMemory as Page
import qualified Test.Worker.TimeBudget as Time
import qualified Test.Worker.TypesAndCompletion as Places

-- | One worker serves one test after the other, as it would serve a class.
main :: IO ()
main = withWorker [] $ \worker -> do
  gallery <- Gallery.tests (pure worker)
  conversations <- Conversation.tests (pure worker)
  graphs <- Graphs.tests (pure worker)
  defaultMain (localOption (NumThreads 1) (testGroup "worker" [Wire.tests, Remember.tests, Page.tests, Time.tests, conversations, graphs, gallery, Places.tests (pure worker), DeclaredTypes.tests (pure worker), Life.tests (pure worker), Prepared.tests (pure worker)]))
