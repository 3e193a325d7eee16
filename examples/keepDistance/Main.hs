-- Drives on, the slower the nearer a wall is, and stands half a metre from it.
keepDistance :: Ahead -> Velocity
keepDistance (Ahead distance)
  | distance > 0.5 = Velocity (min 0.4 (distance - 0.5)) 0
  | otherwise = Velocity 0 0

main :: IO ()
main = simulate keepDistance
