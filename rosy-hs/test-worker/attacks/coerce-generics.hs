{-# LANGUAGE RoleAnnotations #-}
import Data.Coerce

newtype Age = Age Int

main = simulate (Say (show (coerce (Age 3) :: Int)))
