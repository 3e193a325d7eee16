data State = Stand | Go | Back

drive :: Memory State -> Velocity
drive (Memory Stand) = Velocity 0.1 0
drive (Memory Go) = Velocity 0.3 0
drive (Memory Back) = Velocity (-0.2) 0

button :: Button -> Memory State -> Memory State
button (Button _ Pressed) (Memory Stand) = Memory Go
button (Button _ Pressed) (Memory Back) = Memory Stand
button _ state = state

bump :: Bumper -> Memory State
bump (Bumper side status) = Memory Back

main :: IO ()
main = simulate (drive, button, bump)
