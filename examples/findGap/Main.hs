-- A beam that meets nothing looks out through the gap: the robot turns to the middle of these beams, and drives.
findGap :: Scan -> Velocity
findGap (Scan first step _ longest distances)
  | abs way < 0.3 = Velocity 0.2 way
  | otherwise = Velocity 0 (1.5 * way)
  where
    open = [first + n * step | (n, d) <- zip [0 ..] distances, d >= longest]
    way = atan2 (sum (map sin open)) (sum (map cos open))

main :: IO ()
main = simulate findGap
