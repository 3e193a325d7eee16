main = simulate lookup

lookup :: Bumper -> Sound
lookup _ = ErrorSound
