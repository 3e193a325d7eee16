-- |
-- Module      : Rosy.Worker.Branch
-- Description : Branches of a program that is run, as its process and the service are told of them.
module Rosy.Worker.Branch (Branch) where

-- | @Rosy.BranchCoverage.Branch@: start and end as line and column, names of the definitions around, kind, number, and what it is told by.
type Branch = ((Int, Int), (Int, Int), [String], String, Int, String)
