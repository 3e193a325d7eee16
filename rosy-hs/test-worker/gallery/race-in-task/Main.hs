main = simulate t
t :: Task ()
t = race (wait 1) (wait 2)
