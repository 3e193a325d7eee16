-- |
-- Module      : Ros.Service
-- Description : What services are, and a call of one by a program that need not be a node.
--
-- > main = callService "/add_two_ints" (AddTwoIntsRequest 10 5) >>= either (fail . show) (print :: AddTwoIntsResponse -> IO ())
--
-- The types of request and response say which service is meant. "Ros.Node" has 'Ros.Node.requestService', which gets the type of the
-- response from the service's own type, and calls that share a connection.
module Ros.Service
  ( callService,
    Service (..),
    SrvInfo (..),
    ServiceError (..),
    explainServiceError,
  )
where

import Control.Monad (join)
import Data.Bifunctor (first)
import Ros.Names (Name, Naming (..), resolve)
import Ros.Net.Master (Master (..))
import Ros.Net.Rpc (Uri (..))
import Ros.Node.Core (explainNodeError)
import Ros.Node.Run (Settings (..), masterAddress, namingOf, settingsFromSystem)
import Ros.Node.Service (connectService)
import Ros.Service.Class
import Ros.Service.ServiceTypes (ServiceResponseExcept (..))

-- | One call. Master, namespace and remappings are those that environment and arguments give a node, and the caller is called like the
-- program.
callService :: (SrvInfo a, SrvInfo b) => Name -> a -> IO (Either ServiceResponseExcept b)
callService name request = do
  settings <- settingsFromSystem
  case masterAddress settings of
    Left why -> pure (Left (MasterExcept (explainNodeError why)))
    Right address -> do
      let naming = namingOf settings (programName settings)
          -- The address of a node that serves nothing: a lookup of a service registers nothing at the master.
          asker = Master address (ownName naming) (Uri "" 0)
      first inRoshask . join <$> connectService asker False (srvTypeName request, srvMD5 request) (resolve naming name) ($ request)

inRoshask :: ServiceError -> ServiceResponseExcept
inRoshask e = case e of
  NoSuchService _ -> MasterExcept why
  MasterLost _ -> MasterExcept why
  OtherService _ _ -> ConHeadExcept why
  ServiceFailed said -> NotOkExcept said
  ConnectionLost _ -> ConnectExcept why
  StrangeAnswer _ -> ResponseReadExcept why
  where
    why = explainServiceError e
