square :: Task ()
square = do
  repeat 4
    drive 50
    turn 90

main = simulate square
