-- written with tabs in school
drive :: Bumper -> Velocity
drive b = case b of
	Bumper LeftBumper Pressed -> Velocity 0 1
	Bumper RightBumper Pressed -> Velocity 0 (-1)
	_ -> Velocity 0.2 0

main :: IO ()
main = do
	simulate drive
