wander :: Task ()
wander = do
  r <- once (\g -> fst (random g))
  if r
    then do
      say "left"
      turn (Left 30)
    else do
      say "right"
      turn (Right 30)
  case r of
    True -> return ()
    False -> do
      wait 1
      wander

main = simulate wander
