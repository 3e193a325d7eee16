go :: Task ()
go = do
  drive 500
  wait 4

main = simulate go
