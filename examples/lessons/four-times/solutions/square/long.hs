square :: Task ()
square = do
  drive 100
  turn 90
  drive 100
  turn 90
  drive 100
  turn 90
  drive 100
  turn 90

main = simulate square
