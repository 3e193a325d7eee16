go :: Bumper -> Call
go _ = call (wait 1)
main = simulate go
