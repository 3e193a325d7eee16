main = simulate finish

finish :: Bumper -> Done ()
finish _ = Done ()
