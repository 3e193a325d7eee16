main = simulate (light, go)

light :: Memory Bool -> Led1
light (Memory hit) = if hit then Led1 Red else Led1 Green

go :: Bumper -> Velocity
go _ = Velocity 0 0
