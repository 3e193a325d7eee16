main = simulate f
f :: Bumper -> Sound
f b = if (b == Bumper LeftBumper Pressed) { ErrorSound } else { ButtonSound }
