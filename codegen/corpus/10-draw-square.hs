data Direction = Forward Centimeters | Backward Centimeters

move :: Direction -> Task ()
move d = task start run
  where
    start :: Position -> Memory Position
    start p = Memory p
    run (Memory from) to
      | magnitudeVec v >= goal = Right (Done ())
      | otherwise = Left (Velocity speed 0)
      where v = positionToVec to `subVec` positionToVec from
    (goal, speed) = case d of
      Forward c -> (centimetersToMeters c, 0.3)
      Backward c -> (centimetersToMeters c, -0.3)

drawSquare :: Task ()
drawSquare = replicateM_ 4 $ do
  move (Forward 32)
  turn (Left 90)

main :: IO ()
main = simulate drawSquare
