<!-- my program -->
main = simulate (drive 50)
