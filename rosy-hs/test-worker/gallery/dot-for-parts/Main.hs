main = simulate f
f :: Position -> Velocity
f p = if p.x > 3 then Velocity 0 0 else Velocity 1 0
