main = simulate do
  say "hello"
  wait 1
