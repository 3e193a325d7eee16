go :: Task ()
go = do
  drive 100
  turn 120
  drive 100
  turn 120
  drive 100
  turn 120

main = simulate go
