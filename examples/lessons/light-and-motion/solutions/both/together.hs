all :: (Velocity, Led1, Led2)
all = (Velocity 0.2 0, Led1 Green, Led2 Red)

main = simulate all
