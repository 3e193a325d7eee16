remote :: Button -> Maybe Velocity
remote (Button Button0 Pressed) = Just (Velocity 0.2 0)
remote _ = Nothing

main = simulate remote
