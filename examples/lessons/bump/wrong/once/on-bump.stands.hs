beep :: Bumper -> Maybe Sound
beep (Bumper _ Pressed) = Just ErrorSound
beep _ = Nothing

main = simulate beep
