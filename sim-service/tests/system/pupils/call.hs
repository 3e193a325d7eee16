-- call with feedback, cancellation, clean-up
drive :: Task Double
drive = taskWith taskOptions { starting = Memory (0 :: Int), stopped = [Velocity 0 0] } (go, measure)

go :: () -> Velocity
go () = Velocity 0.3 0

measure :: Position -> (Maybe (Feedback Double), Maybe (Done Double))
measure (Position x _) = (if x > 0.2 then Just (Feedback x) else Nothing, if x > 3 then Just (Done x) else Nothing)

start :: ButtonZero -> Maybe Call
start (ButtonZero Pressed) = Just (call drive callOptions { cancelOn = \(ButtonOne _) -> Just Cancel, onFeedback = \x -> if x > (0.3 :: Double) then Just (Led1 Green) else Nothing, onEnd = \x -> Say ("got " ++ show (round x :: Int)) })
start _ = Nothing

main = simulate start
