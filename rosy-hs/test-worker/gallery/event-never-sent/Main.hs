data Crash = Crash

main = simulate (go, shout)

go :: Bumper -> Velocity
go _ = Velocity 0.2 0

shout :: Crash -> Sound
shout Crash = ErrorSound
