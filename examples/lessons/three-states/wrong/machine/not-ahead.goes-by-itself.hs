data State = Stand | Go | Back

drive :: Memory State -> Velocity
drive (Memory Stand) = Velocity 0 0
drive (Memory Go) = Velocity 0.3 0
drive (Memory Back) = Velocity (-0.2) 0

button :: Button -> Memory State -> Memory State
button (Button _ Pressed) (Memory Stand) = Memory Go
button (Button _ Pressed) (Memory Back) = Memory Stand
button _ state = state

bump :: Bumper -> Memory State
bump (Bumper _ Pressed) = Memory Back
bump (Bumper _ Released) = Memory Go

main :: IO ()
main = simulate (drive, button, bump)
