main = simulate deep

deep :: Velocity -> Velocity
deep (Velocity v w) = Velocity (foldr (+) v [1 .. 3000000]) w
