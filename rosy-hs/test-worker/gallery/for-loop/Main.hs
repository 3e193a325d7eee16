main = simulate square
square = do
  for i in 1..4
    move 1
