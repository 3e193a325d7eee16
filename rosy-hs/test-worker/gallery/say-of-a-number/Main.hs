ask :: Task Double
ask = do
  x <- measure
  return x / 2
measure :: Task Double
measure = return 3
main = simulate (ask >>= say)
