explore :: Task Centimeters
explore = task (Velocity 0.2 0) onBump

onBump :: Bumper -> Position -> Done Centimeters
onBump _ (Position x _) = Done (metersToCentimeters x)

measure :: Task ()
measure = do
  distance <- explore
  say "there"

main = simulate measure
