main = simulate cruise and hit

cruise :: () -> Velocity
cruise () = Velocity 0.2 0

hit :: Bumper -> Sound
hit _ = ErrorSound
