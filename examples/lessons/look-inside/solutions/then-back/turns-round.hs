go = do
  untilBump
  drive (-10)
  turn 180
  drive 40

main = simulate go

go :: Task ()

untilBump :: Task ()
untilBump = task start watch

start :: Velocity
start = Velocity 0.3 0

watch :: Bumper -> Done ()
watch _ = Done ()
