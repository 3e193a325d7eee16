remote :: Button -> Velocity -> Maybe Velocity
remote (Button Button0 Pressed) _ = Just (Velocity 0.2 0)
remote (Button Button1 Pressed) (Velocity v _) = Just (Velocity (v + 0.2) 0)
remote (Button Button2 Pressed) _ = Just (Velocity 0 0)
remote _ _ = Nothing

main = simulate remote
