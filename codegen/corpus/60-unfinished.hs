-- homework: let the robot stop when it hits something
go :: Bumper -> Velocity
go b = _

help :: Bumper -> Velocity
help (Bumper s Pressed) = Velocity _speed 0
help (Bumper s Released) = _

main :: IO ()
main = simulate go
