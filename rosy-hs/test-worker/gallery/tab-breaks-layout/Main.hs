main = simulate dance

dance :: Task ()
dance = do
    wait 1
	say "hello"
