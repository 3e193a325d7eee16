go :: Task ()
go = do
  turn 90
  drive 100
  turn (-90)
  drive 100

main = simulate go
