main = simulate greet

greet :: Bumper -> Say
greet _ = Say “ouch"
