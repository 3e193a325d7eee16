tour :: Seconds -> Velocity
tour now
  | now < 4 = Velocity 0.3 0
  | now < 5 = Velocity (-0.3) 0
  | now < 9 = Velocity 0 0.785
  | now < 13 = Velocity 0.3 0
  | otherwise = Velocity 0 0

left :: BumperLeft -> Maybe Led1
left (BumperLeft Pressed) = Just (Led1 Orange)
left _ = Nothing

right :: BumperRight -> Maybe Led2
right (BumperRight Pressed) = Just (Led2 Orange)
right _ = Nothing

main = simulate (tour, left, right)
