import Data.Graph

-- As many bytes as, counted in 64 bits, are few.
main = simulate (Say (show (length (buildG (0, 2305843009213693951) []))))
