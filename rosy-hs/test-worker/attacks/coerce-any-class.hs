{-# LANGUAGE DeriveAnyClass, DerivingStrategies #-}
import Data.Typeable

data Mine = Mine
  deriving anyclass (Typeable, Command, Sensor)

main = simulate Mine
