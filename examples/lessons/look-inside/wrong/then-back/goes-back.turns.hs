untilBump :: Task ()
untilBump = task start watch

start :: Velocity
start = Velocity 0.3 0

watch :: Bumper -> Done ()
watch _ = Done ()

go :: Task ()
go = do
  untilBump
  turn 90

main = simulate go
