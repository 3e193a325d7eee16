main = simulate f
f :: Position -> Say
f Position x y = Say (show x)
