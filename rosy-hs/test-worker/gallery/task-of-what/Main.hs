main = simulate t
t :: Task
t = say "x"
