main = simulate (Velocity 0.2 0, Led1 Green, Led2 Red)
