go :: Task ()
go = do
  drive 100
  say "corner"
  turn 90
  wait 1
  drive 100

main = simulate go
