start :: RobotStatus -> Velocity
start _ = Velocity 0.3 0

bump :: Bumper -> Velocity
bump _ = Velocity (-0.3) 0

beep :: Bumper -> Maybe Sound
beep (Bumper _ Pressed) = Just ButtonSound
beep _ = Nothing

main = simulate (start, bump, beep)
