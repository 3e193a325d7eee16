main = simulate (remember, light)

remember :: Bumper -> Memory Bool
remember _ = Memory True

light :: Bumper -> Led1
light _ = Led1 Red
