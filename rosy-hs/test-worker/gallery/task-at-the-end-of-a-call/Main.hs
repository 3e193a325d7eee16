go :: Bumper -> Call
go _ = call plan callOptions { onEnd = say "done" }
plan :: Task ()
plan = wait 1
main = simulate go
