main = simulate square
square :: Task ()
square = do
  replicateM_ 4 do
    say "side"
    wait 1
