plan = do
    wait 1
  say "a"
main = simulate plan
