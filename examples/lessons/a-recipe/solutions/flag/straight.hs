go :: Task ()
go = do
  turn 45
  drive 142

main = simulate go
