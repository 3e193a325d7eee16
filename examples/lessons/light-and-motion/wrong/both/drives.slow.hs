main = simulate (Velocity 0.1 0, Led1 Green, Led2 Red)
