go :: Task ()
go = do
  drive 100

main = simulate go
