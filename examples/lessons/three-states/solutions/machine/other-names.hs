data Mode = Rest | Ahead | Away

drive :: Memory Mode -> Velocity
drive (Memory mode) = Velocity (speed mode) 0

speed :: Mode -> Double
speed Rest = 0
speed Ahead = 0.4
speed Away = -0.1

button :: Button -> Memory Mode -> Memory Mode
button (Button _ Pressed) (Memory Rest) = Memory Ahead
button (Button _ Pressed) (Memory Away) = Memory Rest
button _ mode = mode

bump :: Bumper -> Memory Mode
bump _ = Memory Away

main :: IO ()
main = simulate (drive, button, bump)
