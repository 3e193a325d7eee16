main = simulate t
t :: Task ()
t = do
  n <- task () f
  say n
f :: Bumper -> Done Int
f _ = Done 3
