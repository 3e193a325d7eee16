main = simulate (do
  call (wait 1) callOptions
  wait 3)
