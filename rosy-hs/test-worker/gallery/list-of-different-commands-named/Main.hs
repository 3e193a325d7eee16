main = simulate both

both = [Velocity 0.5 0, Led1 Red]
