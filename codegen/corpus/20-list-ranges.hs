countdown :: Task ()
countdown = do
  forM_ [10, 9 .. 1] $ \n -> say (show n)
  forM_ [1 .. 3] (\n -> say (show (n * n)))
  mapM_ (say . show) [x * y | x <- [1 .. 3], y <- [x .. 3], odd (x + y)]
  say "lift off"

main :: IO ()
main = simulate countdown
