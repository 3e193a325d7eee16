main = simulate greet

greet :: Bumper -> String
greet _ = "hello"
