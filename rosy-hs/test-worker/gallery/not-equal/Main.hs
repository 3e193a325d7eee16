main = simulate f
f :: Seconds -> Velocity
f s = if s != 3 then Velocity 0 1 else Velocity 0 0
