data Mode = Go | Turn | Stop

main = simulate (change, drive)

change :: Bumper -> Memory Mode
change _ = Memory Turn

drive :: Memory Mode -> Velocity
drive (Memory m) = case m of
  Go -> Velocity 0.2 0
  Turn -> Velocity 0 1
  Stop -> Velocity 0 0
