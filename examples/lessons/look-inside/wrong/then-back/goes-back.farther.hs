untilBump :: Task ()
untilBump = task start watch

start :: Velocity
start = Velocity 0.3 0

watch :: Bumper -> Done ()
watch _ = Done ()

go :: Task ()
go = do
  untilBump
  wait 1
  drive (-80)

main = simulate go
