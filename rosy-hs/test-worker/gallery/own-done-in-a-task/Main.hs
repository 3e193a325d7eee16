data Done a = Done a

main = simulate (task (Velocity 0.5 0) stop)

stop :: Bumper -> Done ()
stop _ = Done ()
