go :: Task ()
go = do
  drive 100
  drive 100

main = simulate go
