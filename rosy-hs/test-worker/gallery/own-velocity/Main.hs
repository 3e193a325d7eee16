data Velocity = Fast | Slow

main = simulate go

go :: Bumper -> Velocity
go (Bumper _ Pressed) = Slow
go _ = Fast
