main = simulate (Led2 Red, Led1 Green, Velocity 0.3 0)
