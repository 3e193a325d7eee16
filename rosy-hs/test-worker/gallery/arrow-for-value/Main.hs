main = simulate t
t :: Task ()
t = do
  x <- 3
  say (show x)
