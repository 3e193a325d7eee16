main = simulate (Led1 Green, Led2 Red, Velocity 0.2 0.1)
