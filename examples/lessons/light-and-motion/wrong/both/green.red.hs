main = simulate (Velocity 0.2 0, Led1 Red, Led2 Red)
