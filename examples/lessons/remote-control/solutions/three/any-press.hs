remote :: Button -> Maybe Velocity
remote (Button b Pressed) = Just (speed b)
remote _ = Nothing

speed :: ButtonNumber -> Velocity
speed Button0 = Velocity 0.2 0
speed Button1 = Velocity 0.4 0
speed Button2 = Velocity 0 0

main = simulate remote
