main = simulate flood

flood :: Velocity -> Say
flood _ = Say (replicate 5000000 'x')
