main = simulate back

back :: Bumper -> Velocity
back _ = Velocity 0.2 -speed

speed = 0.5
