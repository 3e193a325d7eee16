go :: Task ()
go = do
  drive 50
  turn 90
  drive 50

main = simulate go
