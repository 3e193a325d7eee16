main = simulate Nothing
