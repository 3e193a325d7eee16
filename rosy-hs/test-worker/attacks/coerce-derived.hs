{-# LANGUAGE TypeFamilies #-}
type family Other a where
  Other Int = String
  Other Age = Int

newtype Age = Age Int

class Turn a where
  turned :: a -> Other a -> Other a

instance Turn Int where
  turned _ s = s

deriving newtype instance Turn Age

main = simulate (Say (show (turned (Age 1) 2)))
