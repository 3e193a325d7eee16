-- |
-- Module      : Ros.Node.Param
-- Description : Haskell values on the parameter server.
module Ros.Node.Param
  ( Param (..),
  )
where

import Ros.Net.XmlRpc (Value (..))

class Param a where
  toValue :: a -> Value

  -- | Nothing when it is of another type.
  fromValue :: Value -> Maybe a

  -- | A list of it: a string is not a list of characters there.
  toValues :: [a] -> Value
  toValues = VArray . map toValue

  fromValues :: Value -> Maybe [a]
  fromValues (VArray vs) = traverse fromValue vs
  fromValues _ = Nothing

instance Param Value where
  toValue = id
  fromValue = Just

instance Param Int where
  toValue = VInt
  fromValue (VInt i) = Just i
  fromValue _ = Nothing

-- | An integer counts: people write @rate: 5@.
instance Param Double where
  toValue = VDouble
  fromValue (VDouble d) = Just d
  fromValue (VInt i) = Just (fromIntegral i)
  fromValue _ = Nothing

instance Param Bool where
  toValue = VBool
  fromValue (VBool b) = Just b
  fromValue _ = Nothing

instance Param Char where
  toValue c = VString [c]
  fromValue (VString [c]) = Just c
  fromValue _ = Nothing
  toValues = VString
  fromValues (VString s) = Just s
  fromValues _ = Nothing

instance Param a => Param [a] where
  toValue = toValues
  fromValue = fromValues
