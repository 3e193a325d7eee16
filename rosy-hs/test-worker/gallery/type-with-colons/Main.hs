type :: Mode = Int

main = simulate (Velocity 0 0)
