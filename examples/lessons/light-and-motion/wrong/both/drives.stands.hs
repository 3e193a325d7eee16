main = simulate (Led1 Green, Led2 Red)
