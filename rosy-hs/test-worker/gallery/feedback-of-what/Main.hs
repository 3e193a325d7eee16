main = simulate start

start :: Button -> Call
start _ = call drive callOptions {onFeedback = \x -> if x > 0.3 then Led1 Green else Led1 Black}

drive :: Task ()
drive = task (Velocity 0.2 0) far

far :: Position -> (Feedback Double, Maybe (Done ()))
far (Position x _) = (Feedback x, if x > 1 then Just (Done ()) else Nothing)
