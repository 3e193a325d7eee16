-- Mutual recursion of tasks, values handed on, race and parallel.
ping :: Int -> Task Int
ping 0 = pure 100
ping n = do
  say ("ping " ++ show n)
  wait 0.1
  pong (n - 1)

pong :: Int -> Task Int
pong n = say "pong" >> wait 0.1 >> ping n

main = simulate $ do
  n <- ping 2
  r <- race (wait 1 >> pure 'a') (wait 0.3 >> pure True)
  (a, b) <- parallel (wait 0.2 >> pure n) (fmap (* 2) (pure 4))
  say (show (n, r, a, b))
  forM_ [1 .. 3 :: Int] (say . show)
  when (a > 5) (say "big")
