untilBump :: Task ()
untilBump = task start watch

start :: Velocity
start = Velocity 0.3 0

watch :: Bumper -> Maybe (Done ())
watch (Bumper _ Pressed) = Just (Done ())
watch _ = Nothing

go :: Task ()
go = do
  untilBump
  drive (-50)

main = simulate go
