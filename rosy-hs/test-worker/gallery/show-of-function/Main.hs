main = simulate greet

greet :: Bumper -> Say
greet b = Say (show greet)
