main = simulate (say ("a" . "b"))
