-- |
-- Module      : Rosy.Robots.ConnectionError
-- Description : Explanations of why a robot cannot be reached.
--
-- In: an error of the system. Out: a clause without a full stop, to stand behind a colon. The system's own text is used only
-- where no explanation fits.
module Rosy.Robots.ConnectionError
  ( explainConnectionError,
  )
where

import Data.List (isInfixOf)
import Foreign.C.Error
import GHC.IO.Exception (IOException (..))
import System.IO.Error (ioeGetErrorString, isUserError)

explainConnectionError :: IOException -> String
explainConnectionError e = case ioe_errno e >>= \n -> lookup' (Errno n) known of
  Just words' -> words'
  Nothing
    | "getAddrInfo" `isInfixOf` ioe_location e -> "no computer here has this name"
    | isUserError e -> ioeGetErrorString e
    | otherwise -> takeWhile (/= '\n') (show e)
  where
    -- Error numbers can be compared and not ordered.
    lookup' n table = case [w | (ns, w) <- table, n `elem` ns] of
      w : _ -> Just w
      [] -> Nothing
    known =
      [ ([eCONNREFUSED], "nothing listens there; is the robot on, and does its server run?"),
        ([eHOSTUNREACH, eNETUNREACH, eTIMEDOUT, eHOSTDOWN], "its computer does not answer; is it on, and in the same network?"),
        ([eCONNRESET, ePIPE, eCONNABORTED], "the other side closed the connection"),
        ([eACCES, ePERM], "you may not use this device; on most systems the group dialout may"),
        ([eNOENT, eNODEV, eNXIO], "it is not plugged in"),
        ([eIO], "the cable was pulled"),
        ([eBUSY], "another program uses it")
      ]
