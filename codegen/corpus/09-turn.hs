type Side = Either Degrees Degrees

turn :: Side -> Task ()
turn s = task (startTurn s) runTurn

startTurn :: Side -> Orientation -> Memory Orientation
startTurn (Left a) o = Memory (o + degreesToOrientation a)
startTurn (Right a) o = Memory (o - degreesToOrientation a)

runTurn :: Memory Orientation -> Orientation -> Either (Velocity) (Done ())
runTurn (Memory to) from
  | abs d <= err = Right (Done ())
  | otherwise = Left (Velocity 0 (orientation d))
  where
    d = normOrientation (to - from)
    err = 0.01
    orientation (Orientation o) = o

main :: IO ()
main = simulate (turn (Left 90))
