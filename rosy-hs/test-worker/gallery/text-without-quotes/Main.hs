main = simulate (say hello robot)
