go :: Cliff -> Bool -> Velocity
go c on = if on && c == Cliff Any Hole then Velocity 0 0 else Velocity 0.2 0

main = simulate (go, True)
