main = simulate t
t :: Task ()
t = do
  n <- task () f
  drive n
f :: Bumper -> Done Int
f _ = Done 3
