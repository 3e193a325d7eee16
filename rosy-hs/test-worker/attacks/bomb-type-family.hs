{-# LANGUAGE TypeFamilies, UndecidableInstances, DataKinds #-}
type family Grow a where
  Grow a = Grow (a, a)

grown :: Grow Int
grown = grown

main = grown `seq` simulate (Velocity 0 0)
