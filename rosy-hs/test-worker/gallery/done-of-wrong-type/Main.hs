main = simulate go

go :: Task Int
go = task (Velocity 0.5 0) finish

finish :: Bumper -> Done ()
finish _ = Done ()
