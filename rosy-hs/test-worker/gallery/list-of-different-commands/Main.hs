main = simulate [move, light]

move :: Velocity
move = Velocity 0.5 0

light :: Led1
light = Led1 Red
