main = simulate (print "hello")
