main = simulate f
f :: Seconds -> Velocity
f s | s > 3 = Velocity 0 1
    | else = Velocity 0 0
