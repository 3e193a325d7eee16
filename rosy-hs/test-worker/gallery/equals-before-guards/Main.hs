main = simulate f
f :: Bumper -> Sound
f (Bumper s p) =
  | s == LeftBumper = ErrorSound
  | otherwise = ButtonSound
