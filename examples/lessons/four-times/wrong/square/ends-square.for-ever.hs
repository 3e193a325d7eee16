go :: Task ()
go = do
  drive 100
  turn 90
  drive 100
  turn 90
  drive 100
  turn 90
  drive 100
  turn 90
  wait 90

main = simulate go
