main = pure ()

other = simulate (Velocity 0 0)
