newtype Pair = Pair Int Int
main = simulate (Velocity 0 0)
