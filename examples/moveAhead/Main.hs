data Direction = Forward Centimeters | Backward Centimeters

move :: Direction -> Task ()
move (Forward distance) = drive 0.2 distance
move (Backward distance) = drive (-0.2) distance

drive :: Double -> Centimeters -> Task ()
drive speed distance = task startMove (runMove speed distance)

startMove :: Position -> Memory Position
startMove = Memory

runMove ::
  Double ->
  Centimeters ->
  Memory Position ->
  Position ->
  Either Velocity (Done ())
runMove speed distance (Memory start) here
  | gone start here < centimetersToMeters distance = Left (Velocity speed 0)
  | otherwise = Right (Done ())

-- How far it is from one place to another, in metres.
gone :: Position -> Position -> Meters
gone start here = magnitudeVec (positionToVec here `subVec` positionToVec start)

main :: IO ()
main = simulate $ do
  move (Forward 50)
  move (Backward 50)
