data Mode = Go | Stop
drive :: Memory Mode -> Velocity
drive Go = Velocity 0.3 0
drive Stop = Velocity 0 0
main = simulate drive
