go :: Task ()
go = do
  race (drive 500) (wait 4)
  say "enough"

main = simulate go
