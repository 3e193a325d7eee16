main = simulate go

go :: Task ()
go = task (\(Bumper _ _) -> Done ()) taskOpts {init = Velocity 0.2 0, cleanup = Led1 Red}
