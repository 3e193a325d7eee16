data Done = Done

main = simulate stop

stop :: Bumper -> Done
stop _ = Done
