go :: Bumper -> Sound
go (Bumper (LeftBumper | RightBumper) _) = ErrorSound
go _ = OnSound
main = simulate go
