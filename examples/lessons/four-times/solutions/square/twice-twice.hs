side :: Task ()
side = do
  drive 100
  turn 90

half :: Task ()
half = do
  side
  side

main = simulate (do
  half
  half)
