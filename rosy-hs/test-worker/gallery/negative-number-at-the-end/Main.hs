turn :: Velocity
turn = Velocity 0 -0.5

main = simulate turn
