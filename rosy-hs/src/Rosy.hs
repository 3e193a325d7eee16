-- |
-- Module      : Rosy
-- Description : The only import a learner writes.
module Rosy () where
