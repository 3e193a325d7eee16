data State = Stand | Go | Back

drive :: Memory State -> Velocity
drive (Memory Stand) = Velocity 0 0
drive (Memory Go) = Velocity 0.3 0
drive (Memory Back) = Velocity (-0.2) 0

button :: Button -> Memory State
button _ = Memory Go

bump :: Bumper -> Memory State
bump (Bumper side status) = Memory Back

main :: IO ()
main = simulate (drive, button, bump)
