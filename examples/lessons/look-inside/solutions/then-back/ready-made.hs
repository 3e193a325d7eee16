go :: Task ()
go = do
  driveUntilBump
  drive (-50)

main = simulate go
