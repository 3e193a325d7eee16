main = simulate f
f :: Bumper -> [Led1]
f b = [Led1 Red; Led1 Green]
