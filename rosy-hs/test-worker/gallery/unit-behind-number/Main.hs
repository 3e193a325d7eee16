main = simulate $ do
  say "hello"
  wait 2 seconds
  say "bye"
