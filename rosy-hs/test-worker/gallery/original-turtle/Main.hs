main = simulate (setPen 1)
