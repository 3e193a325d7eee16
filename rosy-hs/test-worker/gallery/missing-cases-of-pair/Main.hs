go :: Bumper -> Cliff -> Sound
go b c = case (b, c) of
  (Bumper LeftBumper _, Cliff LeftCliff _) -> ErrorSound
main = simulate go
