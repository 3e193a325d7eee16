onBump :: Bumper -> Done ()
onBump _ = Done

main = simulate (task (Velocity 0.2 0) onBump)
