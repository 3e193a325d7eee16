guard' :: Task () -> Task ()
guard' t = void (race t (task () stop))
stop :: Either Bumper Cliff -> Done ()
stop _ = Done ()
main = simulate $ do
  guard' (parallel (blinkFor 3) (wait 0.4) >> say "both")
  forever' 2 (say "again")
blinkFor :: Int -> Task ()
blinkFor n = replicateM_ n (once (Led1 Red) >> wait 0.1 >> once (Led1 Black) >> wait 0.1)
forever' :: Int -> Task a -> Task ()
forever' n = sequence_ . replicate n
