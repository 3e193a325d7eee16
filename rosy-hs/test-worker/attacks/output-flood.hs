main = simulate flood

flood :: Velocity -> [Say]
flood _ = replicate 20000 (Say (replicate 100 'x'))
