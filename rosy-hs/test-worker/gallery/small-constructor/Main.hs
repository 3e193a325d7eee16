data Mode = go | stop
main = simulate (Memory go)
