go :: Task ()
go = do
  drive (-50)

main = simulate go
