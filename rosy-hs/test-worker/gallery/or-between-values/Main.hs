bump :: Bumper -> Maybe Sound
bump (Bumper side Pressed)
  | side == LeftBumper || RightBumper = Just ErrorSound
bump _ = Nothing

main = simulate bump
