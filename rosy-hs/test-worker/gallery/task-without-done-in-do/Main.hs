main = simulate patrol

patrol :: Task ()
patrol = do
  task (Led1 Green) spin
  say "round"

spin :: Position -> Velocity
spin _ = Velocity 0 1
