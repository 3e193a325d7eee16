main = simulate drive

type Hit = Bool

drive :: Hit -> Velocity
drive hit = if hit then Velocity 0 0 else Velocity 0.5 0
