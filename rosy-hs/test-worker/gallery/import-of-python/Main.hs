import time

main = simulate (drive 20)
