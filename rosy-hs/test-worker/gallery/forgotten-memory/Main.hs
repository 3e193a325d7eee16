main = simulate (remember, drive)

type Hit = Bool

remember :: Bumper -> Memory Hit
remember _ = True

drive :: Memory Hit -> Velocity
drive (Memory hit) = if hit then Velocity 0 0 else Velocity 0.5 0
