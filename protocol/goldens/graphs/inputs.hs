-- Each kind of input: tuples, Either with a state, Maybe, the tick, nothing, and functions without a name.
type Pair = (Bumper, Cliff)

both :: Pair -> Velocity -> Sound
both _ _ = ErrorSound

either' :: Either Bumper Velocity -> Memory Int -> Memory Int
either' _ (Memory n) = Memory (n + 1)

perhaps :: Maybe (Either Bumper Cliff) -> Seconds -> Maybe Led1
perhaps _ _ = Nothing

ticking :: () -> Clock -> Led2
ticking () _ = Led2 Green

never :: Never -> Say
never _ = Say "never"

sensing = (both, either')

main = simulate (sensing, [perhaps], ticking, never, Velocity 0.1 0, \(Button _ status) -> Say (show status))
