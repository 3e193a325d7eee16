{-# LANGUAGE FlexibleContexts #-}

-- |
-- Module      : Ros.Service.Class
-- Description : What a service is: a request and a response, one for one.
--
-- The modules that @rosy-messages@ makes of @.srv@ files import this one. "Ros.Service" calls services, and "Ros.Node" offers them.
module Ros.Service.Class
  ( Service (..),
    SrvInfo (..),
    ServiceError (..),
    explainServiceError,
  )
where

import Ros.Message (Message)

-- | A type whose only value stands for the service.
class (Message (Request s), Message (Response s)) => Service s where
  type Request s
  type Response s

  -- | @std_srvs/SetBool@
  serviceType :: s -> String

  serviceMd5 :: s -> String

-- | The request or the response of a service, which knows whose it is. The values are not looked at.
class Message a => SrvInfo a where
  -- | @std_srvs/SetBool@
  srvTypeName :: a -> String

  srvMD5 :: a -> String

-- | Why a call has no response.
data ServiceError
  = -- | No node offers a service of this name.
    NoSuchService String
  | -- | The service of this name is another one: type and sum there, type and sum here.
    OtherService (String, String) (String, String)
  | -- | The service answers that it failed, in its words.
    ServiceFailed String
  | -- | The node of the service cannot be reached, or was lost before it answered.
    ConnectionLost String
  | -- | The answer cannot be read.
    StrangeAnswer String
  | -- | The master could not be asked.
    MasterLost String
  deriving (Eq, Show)

explainServiceError :: ServiceError -> String
explainServiceError e = case e of
  NoSuchService n -> "No node offers the service " ++ n ++ "."
  OtherService (t, m) (t', m') -> "The service is " ++ t ++ "/" ++ m ++ ", and this program calls " ++ t' ++ "/" ++ m' ++ "."
  ServiceFailed why -> "The service failed: " ++ why
  ConnectionLost why -> "The connection to the service was lost: " ++ why ++ "."
  StrangeAnswer why -> "The service's answer cannot be read: " ++ why ++ "."
  MasterLost why -> "The ROS master could not be asked: " ++ why ++ "."
