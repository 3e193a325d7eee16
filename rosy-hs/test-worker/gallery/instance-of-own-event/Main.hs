data Crash = Crash

instance Sensor Crash

main = simulate (notice, shout)

notice :: Bumper -> Crash
notice _ = Crash

shout :: Crash -> Sound
shout _ = ErrorSound
