turn :: Velocity
turn = Velocity 0 0.39

main = simulate turn
