main = simulate dance

dance :: Task ()
dance = do
  move
  wait 1

move :: Velocity
move = Velocity 0.5 0
