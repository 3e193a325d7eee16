-- Degrees to the left, or to the right.
type Side = Either Degrees Degrees

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
main = simulate (turn (Left 90))
