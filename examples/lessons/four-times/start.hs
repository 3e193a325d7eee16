side :: Task ()
side = do
  drive 100
  turn 90

main = simulate side
