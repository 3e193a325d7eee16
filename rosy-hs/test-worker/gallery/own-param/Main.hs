newtype Param a = Param a

main = simulate slow

slow :: Bumper -> Param Double
slow _ = Param 0.1
