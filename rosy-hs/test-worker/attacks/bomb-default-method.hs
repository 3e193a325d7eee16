{-# LANGUAGE DefaultSignatures #-}
class Endless a where
  endless :: a -> String
  default endless :: Endless [a] => a -> String
  endless a = endless [a]

instance Endless Int

instance Endless [a]

main = simulate (Say (endless (1 :: Int)))
