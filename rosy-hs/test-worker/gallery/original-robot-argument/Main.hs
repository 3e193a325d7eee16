move :: Velocity
move = Velocity 0.5 0
main = simulate (Kobuki Nothing) move
