{-# LANGUAGE FunctionalDependencies #-}
class Next a b | a -> b where
  next :: a -> b

instance Next [a] b => Next a [b] where
  next _ = []

main = simulate (length (next 'x') `seq` Velocity 0 0)
