hit :: Bumper -> Sound
hit _ = ErrorSound

cruise :: () -> Velocity
cruise () = Velocity 0.3 0

main = simulate cruise
