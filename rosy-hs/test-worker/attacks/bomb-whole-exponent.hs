{-# LANGUAGE NumDecimals #-}
huge :: Integer
huge = 1e10000000000

main = simulate (Say (take 5 (show huge)))
