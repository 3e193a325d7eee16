bump :: Bumper -> Memory Double
bump _ = Memory (-0.3)

drive :: Memory Double -> Velocity
drive (Memory v)
  | v == 0 = Velocity 0.3 0
  | otherwise = Velocity v 0

main = simulate (bump, drive)
