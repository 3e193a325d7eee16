main = simulate patrol

patrol = forever
  drive 50
  turn 180
