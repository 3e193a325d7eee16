go :: Bumper -> Sound
go b = case b
  Bumper _ Pressed -> ErrorSound
  _ -> OnSound
main = simulate go
