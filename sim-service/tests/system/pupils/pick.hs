-- two Done types in one program
pick :: Task (Either Int String)
pick = race (task () (\(Button b _) -> Done (fromEnum b))) (wait 0.3 >> pure "none")
main = simulate (pick >>= either (say . show) say)

