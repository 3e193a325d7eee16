-- |
-- Module      : Ros.Service.ServiceTypes
-- Description : Why a call by 'Ros.Service.callService' has no response, in roshask's words.
module Ros.Service.ServiceTypes
  ( ServiceResponseExcept (..),
  )
where

-- | Each with a sentence that says more.
data ServiceResponseExcept
  = -- | The service answers that it failed, in its words.
    NotOkExcept String
  | -- | The answer cannot be read.
    ResponseReadExcept String
  | -- | No node offers the service, or the master could not be asked.
    MasterExcept String
  | -- | The service of this name is another one.
    ConHeadExcept String
  | -- | The node of the service cannot be reached, or was lost before it answered.
    ConnectExcept String
  | -- | Not given by this library, which counts a request that cannot be sent as a lost connection.
    SendRequestExcept String
  deriving (Eq, Show)
