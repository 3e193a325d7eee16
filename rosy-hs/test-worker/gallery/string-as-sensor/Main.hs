main = simulate shout

shout :: String -> Say
shout s = Say s
