main = simulate (greet, Led1 Green)

greet :: Bumper -> Task ()
greet _ = do
  say "hello"
  wait 1
