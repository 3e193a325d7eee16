main = simulate go

go :: Bumper -> Seconds -> Velocity
go (Bumper _ Pressed) s
  | s < 5 = Velocity 0.2 0
  | s < 10 = Velocity 0 1
go (Bumper _ Released) _ = Velocity 0 0
