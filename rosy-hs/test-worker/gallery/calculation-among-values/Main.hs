speed = 0.5

drive = Velocity speed * 2 0

main = simulate drive
