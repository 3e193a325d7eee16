main = simulate (lift, alarm, count)

data Cancel = Cancel

lift :: Wheel -> Memory Int -> Either Cancel (Memory Int)
lift (Wheel _ Air) _ = Left Cancel
lift _ (Memory n) = Right (Memory (n + 10))

alarm :: Cancel -> Orientation -> Sound
alarm Cancel _ = ErrorSound

count :: Maybe Cancel -> Memory Int -> (Memory Int, Say)
count c (Memory n) = (Memory (n + 1), Say (maybe "tick " (const "cancel ") c ++ show n))
