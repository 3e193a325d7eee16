go :: Task ()
go = do
  drive 50
  drive 50
  turn 90
  drive 100

main = simulate go
