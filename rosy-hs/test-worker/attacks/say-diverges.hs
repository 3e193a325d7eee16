main = simulate (Say (show (until (< 0) (+ 1) (0 :: Integer))))
