-- Degrees to the left, or to the right.
type Side = Either Degrees Degrees

data Direction = Forward Centimeters | Backward Centimeters

drawSquare :: Task ()
drawSquare = replicateM_ 4 $ do
  move (Forward 50)
  turn (Left 90)

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

turn :: Side -> Task ()
turn side = task (startTurn side) runTurn

startTurn :: Side -> Orientation -> Memory Orientation
startTurn (Left angle) here = Memory (here + degreesToOrientation angle)
startTurn (Right angle) here = Memory (here - degreesToOrientation angle)

runTurn :: Memory Orientation -> Orientation -> Either Velocity (Done ())
runTurn (Memory goal) here
  | abs rest < 0.02 = Right (Done ())
  | rest > 0 = Left (Velocity 0 0.5)
  | otherwise = Left (Velocity 0 (-0.5))
  where
    rest = normOrientation (goal - here)

main :: IO ()
main = simulate drawSquare
