go :: Task ()
go = do
  drive 200

main = simulate go
