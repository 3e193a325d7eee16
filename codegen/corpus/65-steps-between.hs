square :: Task ()
square = replicateM_ 4 $ do
  say "go"
  task start run
  wait 0.5

start :: Position -> Memory Position
start p = Memory p

run :: Memory Position -> Position -> Either Velocity (Done ())
run (Memory from) here
  | far < 0.5 = Left (Velocity 0.3 0)
  | otherwise = Right (Done ())
  where
    far = magnitudeVec (positionToVec here `subVec` positionToVec from)

main = simulate square
