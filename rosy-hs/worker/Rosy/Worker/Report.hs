-- |
-- Module      : Rosy.Worker.Report
-- Description : Result of a check.
module Rosy.Worker.Report
  ( Report (..),
    emptyReport,
  )
where

import Rosy.Worker.Graph (Connection, Part)
import Rosy.Worker.Problem (Declaration, Function, Problem, Span, Typed)

data Report = Report
  { problems :: ![Problem],
    declarations :: ![Declaration],
    functions :: ![Function],
    -- | The network that the program runs, in the order of the text. Not strict: a run does not need it.
    parts :: [Part],
    -- | The topics that the program connects its own types to, in the order of the text. Not strict either.
    topics :: [Connection],
    -- | In source order, outer spans before inner ones.
    types :: ![Typed],
    -- | The composite nodes of the parsed program ("Rosy.Worker.Ghc.SyntaxGroups"); absent when it cannot be parsed. Not strict either.
    groups :: Maybe [Span]
  }
  deriving (Eq, Show)

emptyReport :: [Problem] -> Report
emptyReport ps = Report ps [] [] [] [] [] Nothing
