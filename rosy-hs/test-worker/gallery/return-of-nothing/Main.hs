main = simulate t
t :: Task ()
t = do
  say "x"
  return
