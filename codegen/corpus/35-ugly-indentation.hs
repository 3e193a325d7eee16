go :: Bumper
   -> Velocity
go (Bumper
      LeftBumper
      Pressed)
  = Velocity
       0
         1
go (Bumper _ _) =
                    Velocity 0
                             0

main
  = simulate
      go
