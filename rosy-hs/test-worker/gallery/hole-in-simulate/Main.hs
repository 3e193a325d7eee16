main = simulate _
