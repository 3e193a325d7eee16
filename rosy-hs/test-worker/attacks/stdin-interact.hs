main = interact id >> simulate (Velocity 0 0)
