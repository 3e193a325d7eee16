go :: Task ()
go = replicate 4 (say "x")

main = simulate go
