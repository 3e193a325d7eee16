{-# LANGUAGE DeriveDataTypeable #-}
import Data.Data

data Twin = Twin Int deriving (Data)

main = simulate (Say (maybe "no" (\(Twin n) -> show n) (gfoldl (\k x -> k >>= \f -> f <$> cast x) pure (Twin 1))))
