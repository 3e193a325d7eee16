data Mode = Go, Stop
main = simulate (Memory Go)
