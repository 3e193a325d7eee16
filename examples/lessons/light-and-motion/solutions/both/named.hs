go :: Velocity
go = Velocity 0.25 0

lights :: (Led1, Led2)
lights = (Led1 Green, Led2 Red)

main = simulate (go, lights)
