data State = Stand | Go | Back

drive :: Memory State -> Velocity
drive (Memory Stand) = Velocity 0 0
drive (Memory Go) = Velocity 0.3 0
drive (Memory Back) = Velocity (-0.2) 0

next :: Either Button Bumper -> Memory State -> Memory State
next (Left (Button _ Pressed)) (Memory Stand) = Memory Go
next (Left (Button _ Pressed)) (Memory Back) = Memory Stand
next (Right _) _ = Memory Back
next _ state = state

main :: IO ()
main = simulate (drive, next)
