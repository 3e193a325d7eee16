dance :: Bool -> Task ()
dance loud = do
  drive 20
  if loud then say "hey"
  turn 90

main = simulate (dance True)
