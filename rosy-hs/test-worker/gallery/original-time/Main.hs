main = simulate tell

tell :: Button -> Time -> Say
tell _ t = Say (show (hours t))
