drive :: StdGen -> Velocity
drive gen = Velocity 0 (randomR 0 1 gen)

main = simulate drive
