main = simulate (Velocity 0.3 0.3, Led1 Green, Led2 Red)
