import Text.Printf

main = simulate (Say (drop 1999999990 (printf "%2000000000d" (1 :: Int))))
