main = simulate square
square :: Task ()
square = do
  let x <- pure 3
  say (show x)
