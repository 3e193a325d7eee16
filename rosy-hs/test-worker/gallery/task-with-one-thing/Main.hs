main = simulate (task f)
f :: Bumper -> Done ()
f _ = Done ()
