commands :: Bumper -> [Say]
commands (Bumper _ Released) = []
commands (Bumper side Pressed) = map Say ["ouch", "that", "hurt", name side]

name :: BumperSide -> String
name LeftBumper = "left"
name CenterBumper = "middle"
name RightBumper = "right"

main :: IO ()
main = simulate commands
