-- Drives on until something is in the way, and says how far it came.
measure :: Task ()
measure = do
  distance <- explore
  say (show (round distance :: Int) ++ " centimetres")

explore :: Task Centimeters
explore = task (Velocity 0.2 0) (cruise, onBump)

cruise :: () -> Velocity
cruise () = Velocity 0.2 0

onBump :: Bumper -> Position -> Done Centimeters
onBump _ here = Done (metersToCentimeters (magnitudeVec (positionToVec here)))

main :: IO ()
main = simulate measure
