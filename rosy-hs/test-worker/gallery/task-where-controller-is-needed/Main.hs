main = simulate (accelerate, pause)

accelerate :: Velocity -> Velocity
accelerate (Velocity v w) = Velocity (v + 0.5) w

pause :: Bumper -> Task ()
pause _ = wait 1
