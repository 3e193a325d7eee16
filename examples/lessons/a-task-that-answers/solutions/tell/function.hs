explore :: Task Centimeters
explore = task (Velocity 0.2 0) onBump

onBump :: Bumper -> Position -> Done Centimeters
onBump _ here = Done (metersToCentimeters (magnitudeVec (positionToVec here)))

tell :: Centimeters -> Task ()
tell far = say (show (round far))

measure :: Task ()
measure = do
  distance <- explore
  tell distance

main = simulate measure
