data State = Stand | Go | Back

drive :: Memory State -> Velocity
drive (Memory Stand) = Velocity 0 0
drive (Memory Go) = Velocity 0.3 0
drive (Memory Back) = Velocity (-0.2) 0

button :: Button -> Memory State -> Maybe (Memory State)
button (Button Button0 Pressed) (Memory Stand) = Just (Memory Go)
button (Button Button0 Pressed) (Memory Back) = Just (Memory Stand)
button _ _ = Nothing

bump :: Bumper -> Memory State
bump (Bumper side status) = Memory Back

main :: IO ()
main = simulate (drive, button, bump)
