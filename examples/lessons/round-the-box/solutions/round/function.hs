circle :: Velocity -> Velocity
circle _ = Velocity 0.3 0.2

main = simulate circle
