main = simulate f
f :: Bumper -> Say
f b = Say "hit" ++ show b
