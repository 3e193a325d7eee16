main = simulate (accelerate, pause)

accelerate :: Velocity -> Velocity
accelerate (Velocity v w) = Velocity (v + 0.5) w

pause :: Task ()
pause = wait 1
