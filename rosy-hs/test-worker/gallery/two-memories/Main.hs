main = simulate (remember, recall)

remember :: Bumper -> Memory Bool
remember _ = Memory 1.5

recall :: Memory Double -> Velocity
recall (Memory x) = Velocity x 0
