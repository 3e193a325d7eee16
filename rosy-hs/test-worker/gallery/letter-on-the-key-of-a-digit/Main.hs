main = simulate (Velocity à.2 à)
