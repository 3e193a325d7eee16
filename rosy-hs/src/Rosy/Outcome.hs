{-# LANGUAGE DeriveFunctor #-}
{-# LANGUAGE DeriveGeneric #-}

-- |
-- Module      : Rosy.Outcome
-- Description : How a call of an action or a service ended.
module Rosy.Outcome
  ( Outcome (..),
  )
where

import GHC.Generics (Generic)
import Rosy.Command
import Rosy.Sensor
import Rosy.Value

-- | How an action or a call of a service ended.
data Outcome a
  = -- | The goal was reached, or the service has answered.
    Succeeded a
  | -- | The server did not accept it, for this reason.
    Rejected String
  | -- | The server gave it up, for this reason.
    Aborted String
  | -- | The server was asked to stop by another program.
    Cancelled
  | -- | There is no such server, or it cannot be reached, for this reason.
    Unavailable String
  deriving (Eq, Ord, Show, Read, Generic, Functor)

instance Value a => Value (Outcome a)

instance Value a => Default (Outcome a)

instance Value a => Sensor (Outcome a)

instance Value a => Command (Outcome a)
