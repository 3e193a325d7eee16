{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Robots.ConnectionError
-- Description : Explanations of why a robot cannot be reached.
--
-- In: an error of the system. Out: a clause without a full stop, to stand behind a colon. The system's own text is used only
-- where no explanation fits. An error that this program has thrown carries its sentence ('portable').
module Rosy.Robots.ConnectionError
  ( explainConnectionError,
  )
where

import Data.List (isInfixOf)
import qualified Data.Text as Text
import Foreign.C.Error
import GHC.IO.Exception (IOException (..))
import Rosy.Sentence
import System.IO.Error (ioeGetErrorString, isUserError)

explainConnectionError :: IOException -> Sentence
explainConnectionError e = case ioe_errno e >>= \n -> lookup' (Errno n) known of
  Just words' -> words'
  Nothing
    | "getAddrInfo" `isInfixOf` ioe_location e -> tr "no computer here has this name"
    | isUserError e -> fromPortable (ioeGetErrorString e)
    | otherwise -> verbatim (Text.pack (takeWhile (/= '\n') (show e)))
  where
    -- Error numbers can be compared and not ordered.
    lookup' n table = case [w | (ns, w) <- table, n `elem` ns] of
      w : _ -> Just w
      [] -> Nothing
    known =
      [ ([eCONNREFUSED], tr "nothing listens there; is the robot on, and does its server run?"),
        ([eHOSTUNREACH, eNETUNREACH, eTIMEDOUT, eHOSTDOWN], tr "its computer does not answer; is it on, and in the same network?"),
        ([eCONNRESET, ePIPE, eCONNABORTED], tr "the other side closed the connection"),
        ([eACCES, ePERM], tr "you may not use this device; on most systems the group dialout may"),
        ([eNOENT, eNODEV, eNXIO], tr "it is not plugged in"),
        ([eIO], tr "the cable was pulled"),
        ([eBUSY], tr "another program uses it")
      ]
