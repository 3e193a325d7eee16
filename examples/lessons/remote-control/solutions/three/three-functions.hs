go :: Button -> Maybe Velocity
go (Button Button0 Pressed) = Just (Velocity 0.2 0)
go _ = Nothing

fast :: Button -> Maybe Velocity
fast (Button Button1 Pressed) = Just (Velocity 0.6 0)
fast _ = Nothing

halt :: Button -> Maybe Velocity
halt (Button Button2 Pressed) = Just (Velocity 0 0)
halt _ = Nothing

main = simulate (go, fast, halt)
