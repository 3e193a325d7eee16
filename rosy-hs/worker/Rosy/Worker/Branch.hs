-- |
-- Module      : Rosy.Worker.Branch
-- Description : Branches of a program that is run, as its process and the service are told of them.
module Rosy.Worker.Branch (Branch) where

-- | @Rosy.BranchCoverage.Branch@: start and end as line and column, names of the definitions around, kind, number, and the text that shows it.
type Branch = ((Int, Int), (Int, Int), [String], String, Int, String)
