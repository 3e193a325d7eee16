main = simulate drive

drive :: Velocity Double -> Velocity
drive v = v
