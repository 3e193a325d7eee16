go :: Maybe Bumper -> Velocity
go (Bumper _ Pressed) = Velocity 0 0
go Nothing = Velocity 0.3 0
main = simulate go
