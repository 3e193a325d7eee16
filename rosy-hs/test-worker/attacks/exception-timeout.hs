import System.Timeout

main = timeout 100 (simulate (Velocity 0 0)) >> print "HARM"
