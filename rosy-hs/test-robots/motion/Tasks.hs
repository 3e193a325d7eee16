main :: IO ()
main = simulate $ do
  drive 30
  turn 90
  once (Velocity 0.1 0)
  wait 1
