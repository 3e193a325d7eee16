hit :: Bumper -> Say
hit (Bumper _ Pressed) = Say «ouch»
hit _ = Say "ok"

main = simulate hit
