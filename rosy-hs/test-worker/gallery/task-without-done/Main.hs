main = simulate (task () forwards)

forwards :: Bumper -> Velocity
forwards _ = Velocity 0.2 0
