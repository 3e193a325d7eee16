main = simulate $ do
  say "a"
  when True say "b"
