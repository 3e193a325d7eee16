ghci> main = simulate (Velocity 0.2 0)
