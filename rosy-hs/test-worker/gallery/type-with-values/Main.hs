type Mode = Go | Stop
main = simulate (Memory Go)
