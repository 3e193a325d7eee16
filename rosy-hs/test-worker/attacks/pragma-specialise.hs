{-# SPECIALISE power :: Int -> Int #-}
{-# INLINE power #-}
power :: Num a => a -> a
power x = x * x

{-# RULES "harm" forall x. power x = x #-}

main = simulate (Say (show (power (3 :: Int))))
