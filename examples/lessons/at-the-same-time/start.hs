go :: Task ()
go = do
  drive 100
  blink Red

main = simulate go
