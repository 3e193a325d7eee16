type Gain = Double

follow :: Gain -> Pose -> Velocity
follow k (Pose (Position x y) (Orientation o)) =
  Velocity v w
  where
    v = 0.2 * cos o
    w = k * (yGoal - y) - o
    yGoal = 1.0e-1

main :: IO ()
main = simulate (follow 1.5)
