main = simulate t
t :: Task ()
t = do
  once Velocity 0.5 0
  wait 1
