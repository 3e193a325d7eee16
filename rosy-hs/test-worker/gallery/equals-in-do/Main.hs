main = simulate square
square :: Task ()
square = do
  x = 3
  say (show x)
