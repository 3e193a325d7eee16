play :: Bumper -> Maybe Sound
play (Bumper _ Pressed) = Just ErrorSound
play (Bumper _ Released) = Nothing

accelerate :: Velocity -> Velocity
accelerate (Velocity vl va) = Velocity (vl+0.5) va

main :: IO ()
main = simulate (accelerate, play)
