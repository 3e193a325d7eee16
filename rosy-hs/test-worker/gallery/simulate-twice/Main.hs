a = Velocity 0.5 0
b :: Bumper -> Sound
b _ = ErrorSound
main = simulate a >> simulate b
