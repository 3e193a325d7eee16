turn :: Velocity
turn = Velocity 0 pi/2

main = simulate turn
