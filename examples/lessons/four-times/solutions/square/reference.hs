side :: Task ()
side = do
  drive 100
  turn 90

square :: Task ()
square = do
  side
  side
  side
  side

main = simulate square
