import Debug.Trace

main = simulate (trace (replicate 1000000 'x') (Say "ran"))
