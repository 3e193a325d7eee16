{-# LANGUAGE RoleAnnotations, GADTs #-}
import Data.Coerce

type role Hidden phantom

data Hidden a where
  Hidden :: Show b => b -> Hidden a

main = simulate (case (coerce (Hidden 'x' :: Hidden Int) :: Hidden Bool) of Hidden b -> Say (show b))
