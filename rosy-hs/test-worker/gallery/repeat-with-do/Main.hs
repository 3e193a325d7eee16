main = simulate $ repeat 4 $ do
  drive 50
  turn 90
