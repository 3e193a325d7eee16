remote :: Button -> Maybe Velocity
remote (Button Button0 Pressed) = Just (Velocity 0.2 0)
remote _ = Nothing

halt :: Button -> Maybe Velocity
halt (Button Button2 Pressed) = Just (Velocity 0 0)
halt _ = Nothing

main = simulate (remote, halt)
