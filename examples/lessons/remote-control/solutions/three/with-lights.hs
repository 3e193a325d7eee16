remote :: Button -> Maybe (Velocity, Led1)
remote (Button Button0 Pressed) = Just (Velocity 0.2 0, Led1 Green)
remote (Button Button1 Pressed) = Just (Velocity 0.5 0, Led1 Orange)
remote (Button Button2 Pressed) = Just (Velocity 0 0, Led1 Black)
remote _ = Nothing

main = simulate remote
