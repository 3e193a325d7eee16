count :: Button -> Memory Int -> (Memory Int, Say)
count (Button _ Pressed) (Memory n) = (Memory (n + 1), Say (show (n + 1)))
count (Button _ Released) (Memory n) = (Memory n, Say "...")

main :: IO ()
main = simulate count
