go :: Task ()
go = do
  drive 50
  wait 1
  drive (-50)

main = simulate go
