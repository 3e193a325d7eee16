{-# LANGUAGE GADTs, QuantifiedConstraints #-}
-- The same with a constraint that holds for all types and so for the one that is to be proved.
class (a ~ b) => Same a b

class Evidence a b

instance (forall x. Evidence x b => Same x b, Evidence a b) => Same a b

to :: Same a b => a -> b
to x = x

main = simulate (Say (to (3 :: Int)))
