main = simulate remember

remember :: Bumper -> Memory Bumper
remember _ = Memory 3
