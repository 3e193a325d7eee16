untilBump :: Task ()
untilBump = task start watch

start :: Velocity
start = Velocity 0.3 0

watch :: Bumper -> Done ()
watch _ = Done ()

go :: Task ()
go = do
  untilBump
  say "ouch"
  drive (-50)

main = simulate go
