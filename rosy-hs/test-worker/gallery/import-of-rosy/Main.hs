import rosy

main = simulate (drive 50)
