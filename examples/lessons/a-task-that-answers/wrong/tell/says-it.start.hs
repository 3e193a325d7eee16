explore :: Task Centimeters
explore = task (Velocity 0.2 0) onBump

onBump :: Bumper -> Position -> Done Centimeters
onBump _ (Position x _) = Done (metersToCentimeters x)

measure :: Task ()
measure = do
  say (show (0 :: Int))
  distance <- explore
  wait 1

main = simulate measure
