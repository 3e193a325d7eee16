plan :: Task ()
plan = do
  let speed = 0.3
      time :: Seconds
      time = 4
  let drive = Velocity speed 0
      done s | s > time = Just (Done ())
             | otherwise = Nothing
  t <- once (id :: Seconds -> Seconds)
  task drive done
  let (a, b) = (1, 2)
  say $ show (a + b)

main = simulate plan
