bump :: Bumper -> Maybe Sound
bump b = if b == Pressed then Just ErrorSound else Nothing

main = simulate bump
