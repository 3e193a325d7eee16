round :: Velocity
round = Velocity 0.3 0.2

main = simulate round
