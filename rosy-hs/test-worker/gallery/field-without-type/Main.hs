data Mode = Turn angle | Go
main = simulate (Memory Go)
