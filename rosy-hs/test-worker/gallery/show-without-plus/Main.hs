clock :: Seconds -> Say
clock s = Say (show s " seconds")

main = simulate clock
