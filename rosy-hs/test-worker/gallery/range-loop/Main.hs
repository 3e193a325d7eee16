main = simulate square

square :: Task ()
square = do
  for i in range(4):
    drive 50
    turn 90
