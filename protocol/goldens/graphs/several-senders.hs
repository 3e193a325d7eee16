-- Two functions keep sending the same command, and a third one sends it at times.
forward :: Position -> Velocity
forward _ = Velocity 0.2 0

spin :: Velocity
spin = Velocity 0 1

stop :: Bumper -> Maybe Velocity
stop _ = Just (Velocity 0 0)

main = simulate (forward, spin, stop)
