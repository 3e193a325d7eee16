data Mode = Turn { angle : Double }
main = simulate (Memory (Turn 1))
